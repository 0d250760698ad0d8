/**
 * What the domain says of events, fields, markup and requirements, shown where the author asks for it by one key. Whoever shows such a thing
 * says so by {@link org.sami.dreamm.help.Explained}; the words are the domain's.
 */
@NullMarked
package org.sami.dreamm.help;

import org.jspecify.annotations.NullMarked;
