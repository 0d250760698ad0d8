/**
 * Nets in PNML, the Petri Net Markup Language (ISO/IEC 15909-2): read from strangers' files and written. Each thing in a file that is not supported is a finding
 * with its line.
 *
 * <p>Not here: what a net means, and files of plans.
 */
@NullMarked
package org.sami.petri.pnml;

import org.jspecify.annotations.NullMarked;
