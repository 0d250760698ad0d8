package org.sami.crw.sim.boat;

import org.junit.jupiter.api.Tag;

/** The same over protected links. */
@Tag("long")
class LongOutageOverTlsTest extends LongOutageTest {
    @Override
    TestLinks links() {
        return TestLinks.withKeys();
    }
}
