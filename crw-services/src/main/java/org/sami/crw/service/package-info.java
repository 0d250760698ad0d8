/**
 * The domain's services: allocation of locations to boats, assembly, comparison of distances. Pure functions of their
 * arguments.
 *
 * <p>Belongs here: algorithms on values, each behind an interface of its subject, so that others can stand next to it. Does
 * not belong here: events, activations, boats' proxies and anything with a thread or a clock ({@code crw.handler}).
 *
 * <p>Frames: geographic points on the WGS-84 ellipsoid; plane coordinates in metres, x to the east, y to the north.
 */
@NullMarked
package org.sami.crw.service;

import org.jspecify.annotations.NullMarked;
