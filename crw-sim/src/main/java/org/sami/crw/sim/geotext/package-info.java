/**
 * The earlier system's text form of locations, paths and areas: read, checked, and made into variables of a project.
 *
 * <p>Here belong that form and the variables made of it. Files of projects belong to {@code spn.json}, options to
 * {@code crw.sim.cli}.
 */
package org.sami.crw.sim.geotext;
