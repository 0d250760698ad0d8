/**
 * Subcommands that read what was recorded or written elsewhere: journals of sessions, logs of boats, projects and locations of the
 * earlier system.
 *
 * <p>Does not belong here: how a run goes on with its journal ({@code run}), the formats ({@code org.sami.crw.log}, {@code
 * org.sami.spn.legacy}).
 */
@NullMarked
package org.sami.crw.cli.record;

import org.jspecify.annotations.NullMarked;
