/**
 * Subcommands that run missions, boats and sessions: {@code run}, {@code resume}, {@code demo}, {@code experiment}, {@code session},
 * {@code boat}, {@code stop}.
 *
 * <p>{@link org.sami.crw.cli.run.Execution} is common to those that run one mission. Does not belong here: the runs themselves
 * ({@code org.sami.crw.sim.run}, {@code org.sami.crw.sim.tcp}).
 */
@NullMarked
package org.sami.crw.cli.run;

import org.jspecify.annotations.NullMarked;
