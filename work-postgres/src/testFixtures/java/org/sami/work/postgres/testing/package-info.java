/** A database for tests of this module and of those that divide work. */
@NullMarked
package org.sami.work.postgres.testing;

import org.jspecify.annotations.NullMarked;
