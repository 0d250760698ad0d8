package org.sami.crw.proxy.phone;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.Objects;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.sami.boat.link.Role;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.PairingCode;
import org.sami.boat.link.security.PairingSecret;
import org.sami.boat.link.security.Peer;
import org.sami.crw.proxy.tcp.BoatAddress;

/**
 * What a base offers to phones near it while a person shows the code: a page with the app, and the pairing. The code is the address of the page with a
 * {@link PairingCode} behind its {@code #}, which names this base, its key and six words; it changes after each phone and when its words are used up. Nothing is
 * offered after {@link #close}. Safe for use by several threads.
 */
public final class PhoneOffer implements Closeable {
    private final KeyRing keys;
    private final String baseName;
    private final Listener listener;
    private final AppServer app;
    private final PhoneResponder responder;
    private String code = "";
    private Optional<Phone> waiting = Optional.empty();

    /**
     * How this base presents itself.
     *
     * @param address of this computer in the network of the phones
     * @param apk empty where there is no app to give
     * @param baseName under which phones keep this base's key
     * @param wish the most that phones are to grant this base
     */
    public record Setup(InetAddress address, Optional<ApkFile> apk, String baseName, Role wish) {
        public Setup {
            Objects.requireNonNull(address, "address");
            Objects.requireNonNull(apk, "apk");
            Objects.requireNonNull(baseName, "baseName");
            Objects.requireNonNull(wish, "wish");
            if (address.isAnyLocalAddress()) {
                throw new IllegalArgumentException("one network is chosen, not all of them");
            }
        }
    }

    /**
     * A phone that has proved that it has read the code.
     *
     * @param boat its key and name
     * @param checkCode what the phone shows as well, unless somebody is in between
     */
    public record Phone(Peer boat, String checkCode) {}

    /** What happens; called on threads of the offer. */
    public interface Listener {
        /** A phone has proved itself: a person says {@link #confirm} or {@link #deny}. */
        void proved(Phone phone);

        /** A phone, or something else, was refused for a reason in words. */
        void refused(String why);
    }

    /**
     * Offers it from now on.
     *
     * @param nowMs a clock that is never set
     * @throws IOException if nothing can listen at the address
     */
    public PhoneOffer(Setup setup, KeyRing keys, LongSupplier nowMs, Listener listener) throws IOException {
        this.keys = Objects.requireNonNull(keys, "keys");
        this.listener = Objects.requireNonNull(listener, "listener");
        baseName = setup.baseName();
        app = new AppServer(setup.address(), setup.apk());
        try {
            responder = new PhoneResponder(
                    setup.address(), keys.identity(), baseName, setup.wish(), nowMs, new FromPhones());
        } catch (IOException e) {
            app.close();
            throw e;
        }
    }

    private final class FromPhones implements PhoneResponder.Listener {
        @Override
        public void proved(Peer boat, String checkCode) {
            Phone phone = new Phone(boat, checkCode);
            boolean first;
            synchronized (PhoneOffer.this) {
                first = waiting.isEmpty();
                waiting = waiting.or(() -> Optional.of(phone));
            }
            if (first) {
                listener.proved(phone);
            } else { // what a person confirms is the phone whose check code was shown
                listener.refused(boat.name() + " came while another phone is compared: let it scan the code again");
            }
        }

        @Override
        public void refused(String why) {
            listener.refused(why);
        }
    }

    /** What is to be shown as a QR code now: to be asked again each second, as it changes. It stays while a phone waits for a person's answer. */
    public synchronized String code() {
        if (waiting.isEmpty() && (code.isEmpty() || !responder.isOpen())) {
            PairingSecret words = responder.next();
            InetSocketAddress at = responder.address();
            String address = new BoatAddress(at.getAddress().getHostAddress(), at.getPort()).toString();
            code = app.url() + "#"
                    + new PairingCode(address, baseName, keys.identity().fingerprint(), words);
        }
        return code;
    }

    /** The phone whose check code a person is to compare. */
    public synchronized Optional<Phone> waiting() {
        return waiting;
    }

    /**
     * The person says that the phone shows the same code: its key is kept, and the next phone may come.
     *
     * @throws IOException if the key cannot be kept; the phone waits on then
     */
    public synchronized void confirm() throws IOException {
        if (waiting.isPresent()) {
            keys.add(waiting.get().boat());
            waiting = Optional.empty();
        }
    }

    /** The person says that the phone shows another code, or none: nothing is kept here. */
    public synchronized void deny() {
        waiting = Optional.empty();
    }

    @Override
    public void close() throws IOException {
        app.close();
        responder.close();
    }
}
