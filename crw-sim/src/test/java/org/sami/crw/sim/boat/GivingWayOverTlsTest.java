package org.sami.crw.sim.boat;

/** The same over protected links. */
class GivingWayOverTlsTest extends GivingWayOverTcpTest {
    @Override
    TestLinks links() {
        return TestLinks.withKeys();
    }
}
