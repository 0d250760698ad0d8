/**
 * Reads projects of the earlier system in their neutral export ({@code sami-legacy-project}, version 1) and makes projects of
 * this language of them.
 *
 * <p>Belongs here: the export as it stands ({@link org.sami.spn.legacy.LegacyProject}), its reader, the conversion to the model,
 * and the counts of both. Does not belong here: any name of an event, markup or class of a domain; those stand in the domain's
 * table ({@link org.sami.spn.legacy.LegacyTable}), which is data.
 */
@NullMarked
package org.sami.spn.legacy;

import org.jspecify.annotations.NullMarked;
