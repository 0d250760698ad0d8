package org.sami.crw.session.key;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.Executor;
import org.sami.boat.link.Role;
import org.sami.boat.link.SteadyClock;
import org.sami.crw.proxy.key.BaseKeys;
import org.sami.crw.proxy.phone.ApkFile;
import org.sami.crw.proxy.phone.PhoneOffer;

/**
 * The code for phones as a person watches it: this base offers the app and the pairing while the code is shown, phone after phone; a person compares the check code
 * of each. To be used on the front's thread, on which changes are notified; separate threads use disk and network.
 */
public final class PhoneInvitation {
    private final BaseKeys keys;
    private final Executor front;
    private final Runnable changed;
    private State state = State.OPENING;
    private String said = "";
    private boolean bad;
    private boolean paired;
    private Optional<ApkFile> app = Optional.empty();
    private String appSaid = "";
    private Optional<PhoneOffer> offer = Optional.empty();
    private Optional<PhoneOffer.Phone> waiting = Optional.empty();

    /** How it stands. */
    public enum State {
        /** The app is looked for, and the servers begin. */
        OPENING,
        /** The code is to be shown. */
        SHOWN,
        /** A phone shows a check code, which a person compares. */
        CHECKING,
        /** Its key is being kept. */
        KEEPING,
        /** Nothing can be offered, for a reason in words. */
        FAILED,
        /** Nothing is offered any more. */
        CLOSED
    }

    private PhoneInvitation(BaseKeys keys, Executor front, Runnable changed) {
        this.keys = Objects.requireNonNull(keys, "keys");
        this.front = Objects.requireNonNull(front, "front");
        this.changed = Objects.requireNonNull(changed, "changed");
    }

    /**
     * Begins.
     *
     * @param address of this computer in the phones' network
     * @param front runs the notifications
     * @param changed is called there after each change
     */
    public static PhoneInvitation begin(InetAddress address, BaseKeys keys, Executor front, Runnable changed) {
        PhoneInvitation invitation = new PhoneInvitation(keys, front, changed);
        invitation.work(() -> invitation.open(address));
        return invitation;
    }

    private interface Work {
        void run() throws IOException;
    }

    private void work(Work work) {
        Thread thread = new Thread(
                () -> {
                    try {
                        work.run();
                    } catch (IOException | IllegalArgumentException fault) {
                        front.execute(() -> failed(String.valueOf(fault.getMessage())));
                    }
                },
                "code for phones");
        thread.setDaemon(true);
        thread.start();
    }

    private void open(InetAddress address) throws IOException {
        Optional<ApkFile> found = Optional.empty();
        String words;
        try {
            Optional<Path> file = ApkFile.find();
            found = file.isPresent() ? Optional.of(ApkFile.read(file.get())) : Optional.empty();
            words = found.map(apk -> "The app is " + apk.path() + ", " + apk.size())
                    .orElse("There is no app to give: " + ApkFile.HOW_TO_MAKE + ". Phones that have it are paired");
        } catch (IOException unfit) {
            words = String.valueOf(unfit.getMessage());
        }
        PhoneOffer.Setup setup = new PhoneOffer.Setup(address, found, BaseKeys.nameOfThisBase(), Role.COMMANDER);
        PhoneOffer made = new PhoneOffer(setup, keys.open(), SteadyClock.ofThisMachine(), new FromPhones());
        Optional<ApkFile> apk = found;
        String apkWords = words;
        front.execute(() -> opened(made, apk, apkWords));
    }

    private void opened(PhoneOffer made, Optional<ApkFile> apk, String words) {
        if (state == State.OPENING) {
            offer = Optional.of(made);
            app = apk;
            appSaid = words;
            become(State.SHOWN);
        } else {
            end(made);
        }
    }

    private final class FromPhones implements PhoneOffer.Listener {
        @Override
        public void proved(PhoneOffer.Phone phone) {
            front.execute(() -> {
                if (state == State.SHOWN) {
                    waiting = Optional.of(phone);
                    say("", false);
                    become(State.CHECKING);
                }
            });
        }

        @Override
        public void refused(String why) {
            front.execute(() -> {
                if (state == State.SHOWN) {
                    say("Not paired: " + why, true);
                    changed.run();
                }
            });
        }
    }

    private void become(State next) {
        state = next;
        changed.run();
    }

    private void say(String text, boolean wrong) {
        said = text;
        bad = wrong;
        paired = false;
    }

    private void failed(String why) {
        if (state == State.CLOSED) {
            return;
        }
        say(why, true);
        become(state == State.KEEPING ? State.CHECKING : State.FAILED);
    }

    /** The person says that the phone shows the same code: its key is kept. */
    public void confirm() {
        if (state == State.CHECKING) {
            PhoneOffer of = offer.orElseThrow();
            become(State.KEEPING);
            work(() -> {
                of.confirm();
                front.execute(this::kept);
            });
        }
    }

    private void kept() {
        if (state == State.KEEPING) {
            say("Paired with " + name() + ": say yes on the phone, too. The next phone may come", false);
            paired = true;
            waiting = Optional.empty();
            become(State.SHOWN);
        }
    }

    /** The person says that the phone shows another code, or none: nothing is kept here. */
    public void deny() {
        if (state == State.CHECKING) {
            offer.orElseThrow().deny();
            say(
                    "Not paired: " + name()
                            + " shows another code, or none, so somebody may be in between. Say no there, too",
                    true);
            waiting = Optional.empty();
            become(State.SHOWN);
        }
    }

    private String name() {
        return waiting.map(phone -> phone.boat().name()).orElse("the phone");
    }

    /** Ends it: from now on nothing is offered. */
    public void close() {
        if (state != State.CLOSED) {
            offer.ifPresent(this::end);
            become(State.CLOSED);
        }
    }

    private void end(PhoneOffer of) {
        work(of::close);
    }

    /** How it stands. */
    public State state() {
        return state;
    }

    /** What the QR code says now; it changes after each phone and after some minutes. Empty while none is to be shown. */
    public Optional<String> code() {
        return state == State.SHOWN ? offer.map(PhoneOffer::code) : Optional.empty();
    }

    /** The code that the phone shows as well; empty while no phone waits. */
    public Optional<String> checkCode() {
        return waiting.map(PhoneOffer.Phone::checkCode);
    }

    /** Whether there is an app to give. */
    public boolean hasApp() {
        return app.isPresent();
    }

    /** Which app is given, or how it is made where there is none: one sentence without its full stop. */
    public String appWords() {
        return appSaid;
    }

    /** Whether {@link #words} say that something went wrong. */
    public boolean isBad() {
        return bad;
    }

    /** Whether {@link #words} say that a phone was paired just now. */
    public boolean hasPaired() {
        return paired && state == State.SHOWN;
    }

    /** How it stands, as one sentence without its full stop. */
    public String words() {
        return switch (state) {
            case OPENING -> "The code is made";
            case CHECKING -> bad ? said : "Does " + name() + " show the same check code?";
            case KEEPING -> "Keeping the key of " + name();
            case SHOWN -> said.isEmpty() ? "Waiting for a phone that scans the code" : said;
            case FAILED, CLOSED -> said;
        };
    }
}
