/**
 * Journals of runs in process, and taking up a run whose process died (docs/decisions, 0050).
 *
 * <p>Here belong what such a journal's header says, the comparison of a run that is gone through again with what the
 * journal holds, and the hand-over to living on. How journals are stored belongs to {@code spn.journal}, the run itself to
 * {@code crw.sim.run}.
 */
@NullMarked
package org.sami.crw.sim.resume;

import org.jspecify.annotations.NullMarked;
