package org.sami.mavlink.testing;

/** What does not work on a {@link SmallBoat}, or on its link. Safe for use by several threads. */
public final class SmallBoatFaults {
    private boolean stuck;
    private boolean disarmsItself;
    private boolean cut;
    private boolean frozen;
    private boolean deaf;
    private boolean ignoresMissions;
    private boolean ignoresSpeeds;
    private int refusedMode = -1;
    private String whyNotArm = "";
    private boolean cameraJammed;
    private int cameraBusy; // pictures that it refuses
    private int answers = Integer.MAX_VALUE;
    private int lackedCommand = -1;
    private boolean ignoresOrders;
    private int ignoredNumber; // 0 for none
    private int ignored;

    SmallBoatFaults() {}

    /** Its firmware has no command of this number. */
    public synchronized void lacksCommand(int number) {
        lackedCommand = number;
    }

    synchronized boolean isLacking(int command) {
        return command == lackedCommand;
    }

    /** It does not move from now on, whatever it is ordered; or moves again. */
    public synchronized void stuck(boolean now) {
        stuck = now;
    }

    synchronized boolean isStuck() {
        return stuck || frozen;
    }

    /** It disarms itself from now on as soon as it was armed, as ArduPilot does where its main loop stands still. */
    public synchronized void disarmsItself() {
        disarmsItself = true;
    }

    synchronized boolean isArmable() {
        return !disarmsItself;
    }

    /** Its link is cut from now on, and each new connection at once; or it takes connections again. */
    public synchronized void cut(boolean now) {
        cut = now;
    }

    synchronized boolean isCut() {
        return cut;
    }

    /** Its process stands still, as after {@code kill -STOP}: what comes waits, and is taken when it goes on. */
    public synchronized void frozen(boolean now) {
        frozen = now;
        notifyAll();
    }

    synchronized boolean isFrozen() {
        return frozen;
    }

    /** Returns once its process goes on. */
    synchronized void awaitThaw() {
        try {
            while (frozen) {
                wait();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Nothing that is sent reaches it from now on, as if the sender had died; or it hears again. */
    public synchronized void deaf(boolean now) {
        deaf = now;
    }

    synchronized boolean isDeaf() {
        return deaf;
    }

    /** It answers nothing about missions from now on, or answers again. */
    public synchronized void ignoresMissions(boolean now) {
        ignoresMissions = now;
    }

    /** It gives so many answers about missions from now on, and then none. */
    public synchronized void answersAboutMissions(int most) {
        answers = most;
    }

    /** How many answers about missions it still gives. */
    public synchronized int answersLeft() {
        return answers;
    }

    /** Whether it gives one more answer about missions; it is counted. */
    synchronized boolean mayAnswer() {
        boolean may = !ignoresMissions && answers > 0;
        answers -= may ? 1 : 0;
        return may;
    }

    /** It neither carries out nor answers orders (mode, arming, item) from now on; or does so again. */
    public synchronized void ignoresOrders(boolean now) {
        ignoresOrders = now;
    }

    synchronized boolean isIgnoringOrder() {
        ignored += ignoresOrders ? 1 : 0;
        return ignoresOrders;
    }

    /** It neither carries out nor answers commands of a number from now on, or ignores none where it is 0. */
    public synchronized void ignoresCommand(int number) {
        ignoredNumber = number;
    }

    synchronized boolean isIgnoring(int command) {
        boolean so = command == ignoredNumber;
        ignored += so ? 1 : 0;
        return so;
    }

    /** How many orders it has ignored. */
    public synchronized int ignoredOrders() {
        return ignored;
    }

    /** It refuses this mode from now on. */
    public synchronized void refuseMode(int number) {
        refusedMode = number;
    }

    synchronized boolean isRefused(int mode) {
        return mode == refusedMode;
    }

    /** It refuses to be armed from now on, with this text; empty where it lets itself be armed again. */
    public synchronized void refuseArming(String text) {
        whyNotArm = text;
    }

    /** Why it refuses to be armed; empty where it does not. */
    synchronized String whyNotArm() {
        return whyNotArm;
    }

    /** It takes the speeds that it is ordered, but does not answer, from now on; or answers again. */
    public synchronized void ignoresSpeeds(boolean now) {
        ignoresSpeeds = now;
    }

    synchronized boolean isIgnoringSpeeds() {
        return ignoresSpeeds;
    }

    /** Its camera takes no picture from now on, though the order for one is accepted; or takes them again. */
    public synchronized void jamCamera(boolean now) {
        cameraJammed = now;
    }

    /** Its camera is at its last picture still when it is asked for the next ones, so that it refuses so many. */
    public synchronized void cameraBusy(int times) {
        cameraBusy = times;
    }

    /** Whether it refuses this one. */
    synchronized boolean refusesPicture() {
        return cameraBusy-- > 0;
    }

    synchronized boolean isCameraJammed() {
        return cameraJammed;
    }
}
