/**
 * The earlier system's text form of locations, paths and areas: read, checked, and made into variables of a project.
 *
 * <p>Here belong that form and the variables made of it. Files of projects belong to {@code spn.json}.
 */
@NullMarked
package org.sami.spn.geotext;

import org.jspecify.annotations.NullMarked;
