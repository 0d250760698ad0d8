/**
 * What is settled before a run: its plan, fleet, water and speed, where on earth it takes place, what the plan asks at its start, and
 * which interrupts are to be pressed. Immutable values, and how users write them.
 *
 * <p>Does not belong here: the options of the command line that ask for them ({@code org.sami.crw.cli}).
 */
@NullMarked
package org.sami.crw.sim.run.settings;

import org.jspecify.annotations.NullMarked;
