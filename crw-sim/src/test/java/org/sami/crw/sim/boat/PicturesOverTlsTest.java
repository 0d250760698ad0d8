package org.sami.crw.sim.boat;

/** The same over protected links. */
class PicturesOverTlsTest extends PicturesOverTcpTest {
    @Override
    TestLinks links() {
        return TestLinks.withKeys();
    }
}
