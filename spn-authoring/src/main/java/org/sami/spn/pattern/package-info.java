/**
 * Patterns: ways in which plans are often drawn, offered on a selection of vertices, made as one edit. Each is a class that says where it can
 * stand and what it draws. No window.
 */
@NullMarked
package org.sami.spn.pattern;

import org.jspecify.annotations.NullMarked;
