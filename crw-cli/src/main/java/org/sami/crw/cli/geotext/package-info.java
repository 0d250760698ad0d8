/** Variables of places in words, for the command line. The text form that they come from is {@code org.sami.spn.geotext}. */
@NullMarked
package org.sami.crw.cli.geotext;

import org.jspecify.annotations.NullMarked;
