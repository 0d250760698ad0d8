/**
 * Projects of the earlier system after their import: where they are written, the report of the import, and trial runs of
 * their plans on simulated boats.
 *
 * <p>Belongs here: what {@code crw import-legacy} does beyond reading. Does not belong here: the export's format and its
 * conversion ({@code org.sami.spn.legacy}), the command line ({@code cli}).
 */
@NullMarked
package org.sami.crw.cli.legacy;

import org.jspecify.annotations.NullMarked;
