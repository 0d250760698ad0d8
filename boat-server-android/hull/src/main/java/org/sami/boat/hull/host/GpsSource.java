package org.sami.boat.hull.host;

import java.io.Closeable;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;
import org.sami.boat.hull.nmea.GpsdReader;
import org.sami.boat.hull.nmea.NmeaReader;
import org.sami.boat.hull.nmea.NmeaSentence;
import org.sami.boat.hull.position.GpsFix;
import org.sami.boat.hull.position.PositionFilter;
import org.sami.boat.hull.stream.PortListener;
import org.sami.boat.hull.stream.ReconnectingPort;
import org.sami.boat.hull.stream.StreamPort;
import org.sami.boat.link.SteadyClock;

/** A GPS receiver on a port that is kept open: what it says goes into a position filter. Safe for use by several threads. */
public final class GpsSource implements Closeable {
    private final StreamPort device;
    private final PositionFilter filter;
    private final SteadyClock clock;
    private final HullNews news;
    private final ReconnectingPort port;
    private final boolean gpsd;
    private volatile boolean declinationGiven;

    private GpsSource(StreamPort device, boolean gpsd, PositionFilter filter, SteadyClock clock, HullNews news) {
        this.device = device;
        this.gpsd = gpsd;
        this.filter = filter;
        this.clock = clock;
        this.news = news;
        Consumer<String> lines = gpsd ? new GpsdReader(this::fix)::line : new NmeaReader(new NmeaSink())::line;
        port = new ReconnectingPort(
                device, gpsd ? GpsdReader.MAX_BYTES : NmeaSentence.MAX_BYTES + 2, new Listener(lines));
    }

    /** A receiver that sends NMEA 0183; its headings are the compass. */
    public static GpsSource nmea(StreamPort device, PositionFilter filter, SteadyClock clock, HullNews news) {
        return new GpsSource(device, false, filter, clock, news);
    }

    /** A gpsd. */
    public static GpsSource gpsd(StreamPort device, PositionFilter filter, SteadyClock clock, HullNews news) {
        return new GpsSource(device, true, filter, clock, news);
    }

    /** Sets the magnetic declination in radians; what the receiver says of it does not count any more. */
    public void setDeclination(double radians) {
        declinationGiven = true;
        filter.setDeclination(radians);
    }

    /**
     * Opens the port once, to see whether the receiver is there.
     *
     * @throws IOException that says why it is not
     */
    public void openFirst() throws IOException {
        port.openFirst();
    }

    /** Begins to read; once only. */
    public void start() {
        port.start();
    }

    private void fix(GpsFix fix) {
        filter.gps(fix, clock.getAsLong());
    }

    /** What NMEA sentences say. */
    private final class NmeaSink implements NmeaReader.Sink {
        @Override
        public void fix(GpsFix fix) {
            GpsSource.this.fix(fix);
        }

        @Override
        public void magneticHeading(double rad) {
            filter.compass(rad, clock.getAsLong());
        }

        @Override
        public void trueHeading(double rad) {
            filter.trueCompass(rad, clock.getAsLong());
        }

        @Override
        public void declination(double rad) {
            if (!declinationGiven) {
                filter.setDeclination(rad);
            }
        }
    }

    /** What the port tells. */
    private final class Listener implements PortListener {
        private final Consumer<String> lines;
        private boolean wasLost;

        Listener(Consumer<String> lines) {
            this.lines = lines;
        }

        @Override
        public void opened() {
            if (wasLost) {
                wasLost = false;
                news.say("GPS " + device.name() + " is back");
            }
            if (gpsd) {
                watch();
            }
        }

        private void watch() {
            try {
                port.send(GpsdReader.WATCH.getBytes(StandardCharsets.US_ASCII));
            } catch (IOException gone) {
                port.reopen("it takes no request");
            }
        }

        @Override
        public void line(String line) {
            lines.accept(line);
        }

        @Override
        public void lost(String why) {
            wasLost = true;
            news.say("GPS " + device.name() + " is gone (" + why + "): plug it in again; it is tried every second");
        }
    }

    @Override
    public void close() {
        port.close();
    }
}
