/**
 * What is to be drawn on the operator's map, as immutable values in WGS-84 degrees, radians and metres.
 *
 * <p>Belongs here: layers and what lies on them. Does not belong here: how they come about ({@code org.sami.crw.operator.MapModel}),
 * colours, symbols and pixels.
 */
package org.sami.crw.operator.map;
