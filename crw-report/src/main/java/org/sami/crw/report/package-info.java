/**
 * What a run leaves behind: its report as records, and the report as text.
 *
 * <p>Here belong the report's records, what is computed from them alone, and their words. Pictures and files have packages of their own below.
 * What fills the records belongs to {@code crw.sim.run}, which options ask for them to {@code crw.cli}. Nothing here knows an engine or
 * a clock.
 */
@NullMarked
package org.sami.crw.report;

import org.jspecify.annotations.NullMarked;
