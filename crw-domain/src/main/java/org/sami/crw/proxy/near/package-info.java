/** Boats that announce themselves on the local network by DNS-SD, and bases that find them. */
@NullMarked
package org.sami.crw.proxy.near;

import org.jspecify.annotations.NullMarked;
