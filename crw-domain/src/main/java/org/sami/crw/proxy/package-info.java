/** Boat proxies, the base side of the link. */
package org.sami.crw.proxy;
