package org.sami.crw.sim.boat;

/** The same over protected links, but for a router that drops single frames: it cannot see them there, and bytes that it dropped would end the link. */
class TcpBaseOverTlsTest extends TcpBaseTest {
    @Override
    TestLinks links() {
        return TestLinks.withKeys();
    }

    @Override
    void uploadOverALossyLinkIsReadBackEqualOrFailsForAReason(double loss) {
        // not run: see above
    }
}
