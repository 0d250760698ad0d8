package org.sami.spn.host;

/** Stands still until the test moves it. */
public final class ManualClock implements HostClock {
    private long nowMillis;
    private long wakeMillis = Long.MAX_VALUE;
    private Runnable wake = () -> {};

    @Override
    public long nowMillis() {
        return nowMillis;
    }

    @Override
    public void wakeAt(long millis, Runnable action) {
        wakeMillis = millis;
        wake = action;
    }

    public void moveTo(long millis) {
        nowMillis = millis;
        if (millis >= wakeMillis) {
            wakeMillis = Long.MAX_VALUE;
            wake.run();
        }
    }
}
