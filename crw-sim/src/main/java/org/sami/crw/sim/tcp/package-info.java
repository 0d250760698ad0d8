/**
 * Runs whose boats are other processes, behind TCP, in real time (ARCHITECTURE.md).
 *
 * <p>Here belong the fleet of such a run with its threads and its clock, the wait for its boats, what the base knows of them and keeps in the
 * journal, and taking up such a run after its process died. The links themselves belong to {@code crw.proxy.tcp}, what both
 * kinds of runs need (harness, recorders, the operator, reports) to {@code crw.sim.run}.
 */
@NullMarked
package org.sami.crw.sim.tcp;

import org.jspecify.annotations.NullMarked;
