package org.sami.crw.proxy.near;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import javax.jmdns.JmDNS;
import javax.jmdns.ServiceInfo;
import javax.jmdns.impl.ServiceInfoImpl;
import org.sami.boat.link.BoatAnnouncement;

/**
 * Announces one boat on the local network by DNS-SD, until it is closed: repeated every 30 s, and within seconds when something about the boat changes. Bases forget
 * a boat 60 s after its last announcement. Has a thread of its own; {@link #open} and {@link #close} take up to some seconds.
 */
public final class BoatAnnouncer implements Closeable {
    private static final long LOOK_MS = 1000;

    private final Supplier<BoatAnnouncement> boat;
    private final List<JmDNS> networks = new ArrayList<>();
    private final List<ServiceInfo> services = new ArrayList<>();
    private final ScheduledExecutorService thread = Executors.newSingleThreadScheduledExecutor(work -> {
        Thread thread = new Thread(work, "boat-announcer");
        thread.setDaemon(true);
        return thread;
    });
    private final List<Future<?>> looks = new ArrayList<>();
    private BoatAnnouncement announced; // for the thread, once it has begun

    private BoatAnnouncer(Supplier<BoatAnnouncement> boat) {
        this.boat = boat;
        this.announced = boat.get();
    }

    /**
     * Begins to announce a boat.
     *
     * @param boat what is to be announced now; asked once a second, on a thread of the announcer's
     * @param server where it listens; one that listens on all addresses is announced on all networks but this machine's own
     * @throws IOException that says why it cannot be announced; it is reached by its address all the same
     */
    public static BoatAnnouncer open(Supplier<BoatAnnouncement> boat, InetSocketAddress server) throws IOException {
        BoatAnnouncer announcer = new BoatAnnouncer(boat);
        try {
            List<InetAddress> addresses = LocalNetworks.of(server.getAddress());
            if (addresses.isEmpty()) {
                throw new IOException("this machine has no network with multicast");
            }
            for (InetAddress address : addresses) {
                announcer.announce(address, server.getPort());
            }
        } catch (IOException | RuntimeException e) {
            announcer.close();
            throw new IOException(
                    announcer.announced.boatId() + " is not announced on the network: " + e.getMessage()
                            + "; bases reach it by its address",
                    e);
        }
        Future<?> looking =
                announcer.thread.scheduleWithFixedDelay(announcer::look, LOOK_MS, LOOK_MS, TimeUnit.MILLISECONDS);
        announcer.looks.add(looking);
        return announcer;
    }

    private void announce(InetAddress address, int port) throws IOException {
        JmDNS network = LocalNetworks.open(address);
        networks.add(network);
        ServiceInfo service =
                ServiceInfo.create(LocalNetworks.TYPE, announced.boatId(), port, 0, 0, announced.entries());
        network.registerService(service);
        services.add(service);
    }

    /** A change made while JmDNS still announces the last one is never sent, nor is any after it: it waits. */
    private void look() {
        BoatAnnouncement now = boat.get();
        if (!now.equals(announced) && services.stream().allMatch(BoatAnnouncer::isAnnounced)) {
            announced = now;
            services.forEach(service -> service.setText(now.entries()));
        }
    }

    private static boolean isAnnounced(ServiceInfo service) {
        return ((ServiceInfoImpl) service).isAnnounced();
    }

    /** Takes the announcement back. */
    @Override
    public void close() {
        looks.forEach(look -> look.cancel(false));
        thread.shutdownNow();
        for (JmDNS network : networks) {
            try {
                network.close();
            } catch (IOException stillOpen) {
                // the announcement ages at the bases
            }
        }
    }
}
