/**
 * What the markups of an interaction ask of whoever shows it, as values (appendix .2.3): read once, without a window.
 *
 * <p>Does not belong here: what the engine itself does with a markup ({@code spn.engine}: Mixed Initiative Trigger, Priority), what services
 * do with one ({@code org.sami.crw.handler}: Optimize, Selection Options), and what models make of them ({@code org.sami.crw.operator}).
 */
package org.sami.crw.markup;
