/**
 * What plans ask of aircraft, done through the base's proxies: flights, searches, looking around, and the news of wind, link and targets. Nothing of it
 * knows what an aircraft is made of or over which link it flies; what boats are asked does not belong here.
 */
@NullMarked
package org.sami.uav.handler;

import org.jspecify.annotations.NullMarked;
