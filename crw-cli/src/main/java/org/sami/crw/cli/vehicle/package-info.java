/** The command that lists vehicles of other makers, which speak MAVLink, and its words. */
@NullMarked
package org.sami.crw.cli.vehicle;

import org.jspecify.annotations.NullMarked;
