/**
 * The command {@code crw}: its subcommands, their options, what they print.
 *
 * <p>Here belongs what speaks to a person or a script: options and their checks, progress, exit codes. What a command does
 * belongs to the packages of runs, reports and resuming.
 */
package org.sami.crw.sim.cli;
