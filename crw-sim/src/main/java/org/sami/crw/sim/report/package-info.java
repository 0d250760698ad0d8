/**
 * What a run leaves behind: its report as records, and the forms in which people and programs read it.
 *
 * <p>Here belong the report's records and their writers (JSON, CSV, PNG, text). What fills them belongs to
 * {@code crw.sim.run}, which options ask for them to {@code crw.sim.cli}. Nothing here knows an engine or a clock.
 */
package org.sami.crw.sim.report;
