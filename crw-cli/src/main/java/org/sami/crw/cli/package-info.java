/**
 * The command {@code crw}: {@link org.sami.crw.cli.Crw} lists its subcommands and runs them, with the options that all of them have.
 *
 * <p>The subcommands stand in a package for each subject: {@code plan} (plans and the words they use), {@code run} (missions, boats,
 * sessions), {@code record} (journals, logs and files of the earlier system). They share {@code option} (what they are asked) and
 * {@code output} (what they print, and how they end).
 *
 * <p>Here belongs what speaks to a person or a script: options and their checks, progress, exit codes. What a command does belongs to the
 * packages of runs, reports and resuming.
 */
@NullMarked
package org.sami.crw.cli;

import org.jspecify.annotations.NullMarked;
