package org.sami.crw.proxy.near;

import java.io.Closeable;
import java.io.IOException;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.jmdns.JmDNS;
import javax.jmdns.ServiceEvent;
import javax.jmdns.ServiceInfo;
import javax.jmdns.ServiceListener;
import org.sami.boat.link.BoatAnnouncement;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.spn.value.NaturalOrder;

/**
 * Finds boats that announce themselves on the local network. Boats appear within seconds, change, and go when they take their announcement back or do not repeat
 * it for 60 s. Has a thread of its own until it is closed. Safe for use by several threads.
 */
public final class BoatFinder implements Closeable {
    /** The most boats that are listed: anybody on the network can announce any number. */
    public static final int MOST = 1000;

    private static final Comparator<FoundBoat> IN_ORDER = Comparator.comparing(
                    (FoundBoat boat) -> boat.announcement().boatId(), NaturalOrder.INSTANCE)
            .thenComparing(boat -> boat.address().toString());

    /** The networks to look on. */
    private interface Networks {
        List<InetAddress> list() throws IOException;
    }

    private final Networks on;
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
    private final List<JmDNS> networks = new ArrayList<>();
    private final Map<String, FoundBoat> found = new LinkedHashMap<>();
    private final Map<String, String> unreadable = new TreeMap<>();
    private final List<String> problems = new ArrayList<>();
    private boolean closed;

    private BoatFinder(Networks on) {
        this.on = on;
        inBackground("boat-finder", this::open);
    }

    /** Looks on all networks of this machine, and for boats on it. */
    public static BoatFinder everywhere() {
        return new BoatFinder(LocalNetworks::all);
    }

    /** Looks on the networks of these addresses of this machine. */
    public static BoatFinder on(List<InetAddress> addresses) {
        List<InetAddress> copy = List.copyOf(addresses);
        return new BoatFinder(() -> copy);
    }

    /** Looks on the network of an address of this machine; without one on all. */
    public static BoatFinder on(Optional<InetAddress> address) {
        return address.map(one -> on(List.of(one))).orElseGet(BoatFinder::everywhere);
    }

    /** Adds a listener, which is called after each change, on a thread of the finder's; it is to return at once. */
    public void addListener(Runnable changed) {
        listeners.add(changed);
    }

    /** Removes a listener. */
    public void removeListener(Runnable changed) {
        listeners.remove(changed);
    }

    /** The boats that are near now. A boat that is announced on several networks at one address is listed once. */
    public synchronized FoundBoats snapshot() {
        return new FoundBoats(
                found.values().stream().distinct().sorted(IN_ORDER).toList(),
                new ArrayList<>(unreadable.values()),
                problems);
    }

    private void open() {
        List<InetAddress> addresses;
        try {
            addresses = on.list();
        } catch (IOException e) {
            addresses = List.of();
            problem("the networks of this machine cannot be listed: " + e.getMessage());
        }
        for (InetAddress address : addresses) {
            try {
                look(address);
            } catch (IOException | RuntimeException e) {
                problem("boats are not looked for at " + address.getHostAddress() + ": " + e.getMessage()
                        + "; connect them by their addresses");
            }
        }
    }

    private void look(InetAddress address) throws IOException {
        JmDNS network = LocalNetworks.open(address);
        synchronized (this) {
            if (!closed) {
                networks.add(network);
                network.addServiceListener(LocalNetworks.TYPE, new Announcements(address.getHostAddress(), network));
                return;
            }
        }
        network.close();
    }

    private void problem(String text) {
        synchronized (this) {
            problems.add(text);
        }
        changed();
    }

    private void changed() {
        listeners.forEach(Runnable::run);
    }

    /** Reads the announcements of one network, on the threads of its responder. */
    private final class Announcements implements ServiceListener {
        private final String where;
        private final JmDNS network;

        Announcements(String where, JmDNS network) {
            this.where = where;
            this.network = network;
        }

        @Override
        public void serviceAdded(ServiceEvent event) {
            network.requestServiceInfo(event.getType(), event.getName(), true, 1);
        }

        @Override
        public void serviceResolved(ServiceEvent event) {
            ServiceInfo service = event.getInfo();
            Map<String, String> entries = entries(service);
            if (!entries.isEmpty()) { // its TXT record comes by itself
                take(key(event), service, entries);
            }
        }

        @Override
        public void serviceRemoved(ServiceEvent event) {
            forget(key(event));
        }

        private String key(ServiceEvent event) {
            return where + "/" + event.getName();
        }
    }

    private static Map<String, String> entries(ServiceInfo service) {
        Map<String, String> entries = new TreeMap<>();
        for (String key : Collections.list(service.getPropertyNames())) {
            Optional.ofNullable(service.getPropertyString(key)).ifPresent(value -> entries.put(key, value));
        }
        return entries;
    }

    private void take(String key, ServiceInfo service, Map<String, String> entries) {
        Optional<String> host = hostOf(service);
        synchronized (this) {
            boolean full = found.size() + unreadable.size() >= MOST && !found.containsKey(key);
            if (closed || host.isEmpty() || full) {
                return;
            }
            unreadable.remove(key);
            try {
                FoundBoat boat =
                        new FoundBoat(BoatAnnouncement.parse(entries), new BoatAddress(host.get(), service.getPort()));
                if (boat.equals(found.put(key, boat))) {
                    return;
                }
            } catch (IllegalArgumentException e) {
                found.remove(key);
                unreadable.put(
                        key,
                        "what " + host.get() + ":" + service.getPort() + " announces is left out: " + e.getMessage());
            }
        }
        changed();
    }

    private void forget(String key) {
        synchronized (this) {
            boolean listed = found.remove(key) != null;
            boolean named = unreadable.remove(key) != null;
            if (!listed && !named) {
                return;
            }
        }
        changed();
    }

    private static Optional<String> hostOf(ServiceInfo service) {
        for (Inet4Address address : service.getInet4Addresses()) {
            return Optional.of(address.getHostAddress());
        }
        return Optional.empty();
    }

    /** Ends the search; what it had open is closed in the background, which takes some seconds. */
    @Override
    public void close() {
        List<JmDNS> open;
        synchronized (this) {
            closed = true;
            open = List.copyOf(networks);
            networks.clear();
        }
        listeners.clear();
        for (JmDNS network : open) {
            inBackground("boat-finder-close", () -> {
                try {
                    network.close();
                } catch (IOException alreadyClosed) {
                    // nothing is left to close
                }
            });
        }
    }

    private static void inBackground(String name, Runnable work) {
        Thread thread = new Thread(work, name);
        thread.setDaemon(true);
        thread.start();
    }
}
