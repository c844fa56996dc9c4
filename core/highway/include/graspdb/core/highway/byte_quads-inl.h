// SPDX-License-Identifier: MIT
// Sums of products of bytes, four at a time: for files that Highway compiles once for each
// instruction set. Define HWY_WANT_AVX3_DL before hwy/foreach_target.h: that set does it in one
// instruction.

// Seen once for each instruction set, as Highway's own -inl.h files are.
#if defined(GRASPDB_CORE_HIGHWAY_BYTE_QUADS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GRASPDB_CORE_HIGHWAY_BYTE_QUADS_INL_H_
#undef GRASPDB_CORE_HIGHWAY_BYTE_QUADS_INL_H_
#else
#define GRASPDB_CORE_HIGHWAY_BYTE_QUADS_INL_H_
#endif

#include <hwy/highway.h>

#include <cstdint>
#include <cstring>

// Elsewhere ReorderWidenMulAccumulate spreads its sums over two results: a plain loop does it
// there.
#undef GRASPDB_HAS_BYTE_QUADS
#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128 || !HWY_ARCH_X86
#define GRASPDB_HAS_BYTE_QUADS 0
#else
#define GRASPDB_HAS_BYTE_QUADS 1

HWY_BEFORE_NAMESPACE();
namespace graspdb {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kByteQuadLanes = 16;  // at most
using QuadSums = hn::CappedTag<std::int32_t, kByteQuadLanes>;
using QuadBytes = hn::Repartition<std::int8_t, QuadSums>;
using QuadShorts = hn::Repartition<std::int16_t, QuadSums>;
using QuadSumsVec = hn::Vec<QuadSums>;

// Four neighbouring bytes, as they lie, in every lane.
HWY_INLINE QuadSumsVec QuadAt(const std::uint8_t* HWY_RESTRICT bytes) {
  std::int32_t quad = 0;
  std::memcpy(&quad, bytes, sizeof(quad));
  return hn::Set(QuadSums(), quad);
}

#if HWY_TARGET == HWY_AVX3_DL

using SignedQuads = QuadSumsVec;

// Four of them a lane.
HWY_INLINE SignedQuads LoadSignedQuads(const std::int8_t* HWY_RESTRICT bytes) {
  return hn::BitCast(QuadSums(), hn::LoadU(QuadBytes(), bytes));
}

// Of each lane: the sum and the four products.
HWY_INLINE QuadSumsVec AddProducts(QuadSumsVec sums, QuadSumsVec quads, const SignedQuads& by) {
  // Highway lets its compilers use every instruction of this target but this one.
  asm("vpdpbusd %2, %1, %0" : "+v"(sums.raw) : "v"(quads.raw), "v"(by.raw));
  return sums;
}

#else

// The first and third of each four, the second and fourth, as words.
struct SignedQuads {
  hn::Vec<QuadShorts> even, odd;
};

HWY_INLINE SignedQuads LoadSignedQuads(const std::int8_t* HWY_RESTRICT bytes) {
  const auto all = hn::BitCast(QuadShorts(), hn::LoadU(QuadBytes(), bytes));
  return {hn::ShiftRight<8>(hn::ShiftLeft<8>(all)), hn::ShiftRight<8>(all)};
}

HWY_INLINE QuadSumsVec AddProducts(QuadSumsVec sums, QuadSumsVec quads, const SignedQuads& by) {
  const QuadShorts w;
  const hn::RebindToUnsigned<QuadShorts> u;
  const auto even = hn::And(hn::BitCast(w, quads), hn::Set(w, 255));
  const auto odd = hn::BitCast(w, hn::ShiftRight<8>(hn::BitCast(u, quads)));
  QuadSumsVec none = hn::Zero(QuadSums());
  sums = hn::ReorderWidenMulAccumulate(QuadSums(), even, by.even, sums, none);
  return hn::ReorderWidenMulAccumulate(QuadSums(), odd, by.odd, sums, none);
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace graspdb
HWY_AFTER_NAMESPACE();

#endif
#endif
