package org.sami.crw.sim.boat;

/** The same over protected links. */
class TcpBaseOverTlsTest extends TcpBaseTest {
    @Override
    TestLinks links() {
        return TestLinks.withKeys();
    }
}
