package org.sami.crw.sim.boat;

/** The same over protected links. */
class LongOutageOverTlsTest extends LongOutageTest {
    @Override
    TestLinks links() {
        return TestLinks.withKeys();
    }
}
