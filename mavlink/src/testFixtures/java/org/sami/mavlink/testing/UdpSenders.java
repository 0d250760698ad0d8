package org.sami.mavlink.testing;

import io.dronefleet.mavlink.MavlinkConnection;
import io.dronefleet.mavlink.MavlinkMessage;
import java.io.EOFException;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.util.ArrayList;
import java.util.List;

/** Has small vehicles, which listen on TCP, send to one UDP port on loopback, each message as a datagram, and gives them what is answered there. */
public final class UdpSenders implements AutoCloseable {
    private static final int MAX_DATAGRAM = 2_048;

    private final InetSocketAddress base;
    private final List<AutoCloseable> sockets = new ArrayList<>();
    private final List<Thread> threads = new ArrayList<>();

    /** Nobody sends yet. */
    public UdpSenders(int basePort) {
        base = new InetSocketAddress(InetAddress.getLoopbackAddress(), basePort);
    }

    /** From now on this one sends, too. */
    public void add(SmallBoat boat) throws IOException {
        Socket vehicle = new Socket(InetAddress.getLoopbackAddress(), boat.port());
        sockets.add(vehicle);
        DatagramSocket own = new DatagramSocket(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
        sockets.add(own);
        start("sends of " + boat.address(), () -> send(vehicle, own));
        start("takes for " + boat.address(), () -> take(own, vehicle));
    }

    private void start(String name, Runnable work) {
        Thread thread = new Thread(work, name);
        thread.setDaemon(true);
        threads.add(thread);
        thread.start();
    }

    private void send(Socket vehicle, DatagramSocket own) {
        try {
            MavlinkConnection said =
                    MavlinkConnection.create(vehicle.getInputStream(), OutputStream.nullOutputStream());
            while (!own.isClosed()) {
                MavlinkMessage<?> message = said.next();
                byte[] raw = message.getRawBytes();
                own.send(new DatagramPacket(raw, raw.length, base));
            }
        } catch (EOFException e) {
            // the vehicle has ended
        } catch (IOException e) {
            failUnlessClosed(own, e);
        }
    }

    private static void take(DatagramSocket own, Socket vehicle) {
        DatagramPacket packet = new DatagramPacket(new byte[MAX_DATAGRAM], MAX_DATAGRAM);
        try {
            while (!own.isClosed()) {
                own.receive(packet);
                vehicle.getOutputStream().write(packet.getData(), 0, packet.getLength());
            }
        } catch (IOException e) {
            failUnlessClosed(own, e);
        }
    }

    private static void failUnlessClosed(DatagramSocket own, IOException why) {
        if (!own.isClosed()) {
            throw new UncheckedIOException(why);
        }
    }

    /** Ends it; the vehicles go on. */
    @Override
    public void close() throws Exception {
        for (AutoCloseable socket : sockets) {
            socket.close();
        }
        for (Thread thread : threads) {
            thread.join();
        }
    }
}
