package org.sami.boat.app.phone;

import android.content.Context;
import android.net.nsd.NsdManager;
import android.net.nsd.NsdServiceInfo;
import android.os.Handler;
import android.os.Looper;
import android.util.Log;
import java.util.Map;
import java.util.Optional;
import org.sami.boat.link.BoatAnnouncement;

/**
 * Announces the boat on the phone's network by the phone's own DNS-SD. What is announced cannot be changed there, so it is taken back and announced again when it
 * changes. Without a network nothing is announced, and the boat goes on. For the main thread.
 */
public final class PhoneAnnouncer {
    private static final String TAG = "sami";

    /** What the phone can do; its answers may come on any thread. */
    interface Network {
        /** Asks to announce. */
        void register(NsdServiceInfo service, NsdManager.RegistrationListener listener);

        /** Asks to take it back. */
        void unregister(NsdManager.RegistrationListener listener);
    }

    private final Network network;
    private final Handler main = new Handler(Looper.getMainLooper());
    private Optional<Service> wanted = Optional.empty();
    private Optional<Registration> current = Optional.empty();

    /** Announces nothing yet. */
    public PhoneAnnouncer(Context context) {
        this(new Network() {
            private final NsdManager manager = (NsdManager) context.getSystemService(Context.NSD_SERVICE);

            @Override
            public void register(NsdServiceInfo service, NsdManager.RegistrationListener listener) {
                manager.registerService(service, NsdManager.PROTOCOL_DNS_SD, listener);
            }

            @Override
            public void unregister(NsdManager.RegistrationListener listener) {
                manager.unregisterService(listener);
            }
        });
    }

    PhoneAnnouncer(Network network) {
        this.network = network;
    }

    /** Announces a boat on its port in place of what was announced before. */
    public void announce(BoatAnnouncement boat, int port) {
        want(Optional.of(new Service(boat, port)));
    }

    /** Announces nothing from now on. */
    public void end() {
        want(Optional.empty());
    }

    private void want(Optional<Service> service) {
        wanted = service;
        go();
    }

    /** One step towards what is to be announced, unless an answer is awaited; the answer takes the next one. */
    private void go() {
        if (current.isPresent()) {
            current.get().endUnless(wanted);
        } else if (wanted.isPresent()) {
            Registration next = new Registration(wanted.get());
            current = Optional.of(next);
            next.begin();
        }
    }

    private void ended(Registration registration) {
        if (current.isPresent() && current.get() == registration) {
            current = Optional.empty();
            go();
        }
    }

    /** What is announced. */
    private static final class Service {
        private final Map<String, String> entries;
        private final String name;
        private final int port;

        Service(BoatAnnouncement boat, int port) {
            entries = boat.entries();
            name = boat.boatId();
            this.port = port;
        }

        boolean isSameAs(Service other) {
            return port == other.port && entries.equals(other.entries);
        }

        NsdServiceInfo info() {
            NsdServiceInfo info = new NsdServiceInfo();
            info.setServiceName(name);
            info.setServiceType(BoatAnnouncement.SERVICE_TYPE);
            info.setPort(port);
            entries.forEach(info::setAttribute);
            return info;
        }
    }

    /** One announcement, from its beginning to its end. */
    private final class Registration implements NsdManager.RegistrationListener {
        private final Service service;
        private boolean asked; // to begin or to end, and not answered yet
        private boolean standing;

        Registration(Service service) {
            this.service = service;
        }

        void begin() {
            asked = true;
            try {
                network.register(service.info(), this);
            } catch (RuntimeException e) { // such as one of the phone's network service
                failed("the boat cannot be announced: " + e);
            }
        }

        /** A failed one stays, so that it is not tried at each look; the next change tries again. */
        private void failed(String why) {
            Log.w(TAG, why);
            asked = false;
        }

        void endUnless(Optional<Service> same) {
            boolean stays = same.isPresent() && same.get().isSameAs(service);
            if (stays || asked) {
                return;
            }
            if (!standing) {
                ended(this);
                return;
            }
            asked = true;
            try {
                network.unregister(this);
            } catch (RuntimeException e) {
                Log.w(TAG, "the boat's announcement cannot be taken back", e);
                ended(this);
            }
        }

        @Override
        public void onServiceRegistered(NsdServiceInfo info) {
            main.post(() -> {
                standing = true;
                asked = false;
                endUnless(wanted);
            });
        }

        @Override
        public void onRegistrationFailed(NsdServiceInfo info, int code) {
            main.post(() -> {
                failed("the boat cannot be announced: error " + code);
                endUnless(wanted);
            });
        }

        @Override
        public void onServiceUnregistered(NsdServiceInfo info) {
            main.post(() -> ended(this));
        }

        @Override
        public void onUnregistrationFailed(NsdServiceInfo info, int code) {
            main.post(() -> ended(this));
        }
    }
}
