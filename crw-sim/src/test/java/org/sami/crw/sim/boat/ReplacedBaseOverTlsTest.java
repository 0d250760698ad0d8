package org.sami.crw.sim.boat;

/** The same over protected links. */
class ReplacedBaseOverTlsTest extends ReplacedBaseTest {
    @Override
    TestLinks links() {
        return TestLinks.withKeys();
    }
}
