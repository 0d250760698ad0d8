package org.sami.crw.sim.boat;

/** The same over protected links. */
class ClearWaysOverTlsTest extends ClearWaysOverTcpTest {
    @Override
    TestLinks links() {
        return TestLinks.withKeys();
    }
}
