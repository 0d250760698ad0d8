/**
 * Plans as their authors wrote them: immutable definitions of SAMI Petri Nets (thesis chapter 3).
 *
 * <p>Belongs here: projects, plans, their elements, and look-up of neighbours. Does not belong here: markings and anything
 * that exists only while a mission runs ({@code spn.protocol}, {@code spn.engine}), files ({@code spn.json}).
 */
@NullMarked
package org.sami.spn.model;

import org.jspecify.annotations.NullMarked;
