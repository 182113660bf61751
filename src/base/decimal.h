// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a coordinate move by whole metres without losing what was written?
//
// At 4.5*10^9 m neighbouring doubles are a micrometre apart, so a plain difference is that far off.
// The shortest decimal that reads back as the double is the text of the file whenever that text
// has at most 15 digits: the sum is done on that text, exactly, and rounded once.

namespace vandplan::base {

/// `value` + `whole`, with `whole` a whole number below 2^63. A scenario that was moved by whole
/// metres as a text has bit for bit the same coordinates after moving it back.
[[nodiscard]] double moved(double value, double whole) noexcept;

}  // namespace vandplan::base
