/**
 * The engine: a deterministic function from state and input to state and effects (docs/semantics.md; thesis, Algorithms 1 to 3).
 *
 * <p>Belongs here: what other packages may use. {@code Engine} takes a step, {@code EngineState} is what it changes, {@code
 * EngineView} and {@code MissionView} answer questions about it, {@code StateCodec} makes bytes of it. Does not belong here:
 * threads, clocks, files, and anything that knows one domain. Below lie four packages that only the engine uses: {@code net}
 * (compiled plans), {@code state} (what changes), {@code rule} (who changes it) and {@code codec} (its bytes); each knows only
 * those that it names.
 *
 * <p>Read {@code Engine.step} first, then the packages in the order {@code net}, {@code state}, {@code rule}.
 */
@NullMarked
package org.sami.spn.engine;

import org.jspecify.annotations.NullMarked;
