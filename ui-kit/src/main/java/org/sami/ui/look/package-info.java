/**
 * How windows look: themes, semantic colours, fonts and their scale, spacing, icons, identity colours of proxies. No other package of a
 * window names a colour or a font size of its own.
 */
package org.sami.ui.look;
