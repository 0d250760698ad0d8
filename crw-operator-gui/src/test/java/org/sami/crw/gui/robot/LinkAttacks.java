package org.sami.crw.gui.robot;

import static java.awt.event.KeyEvent.VK_F12;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.function.IntFunction;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BatteryReport;
import org.sami.boat.link.CommandAsked;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Progress;
import org.sami.boat.link.SensorReport;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.proxy.tcp.BoatAddress;

/** What boats, and what passes for boats, do to the window over their links. The boats anna and bert are real. */
final class LinkAttacks {
    /** The rows. */
    static final List<RobotRow> ROWS = List.of(
            new RobotRow(
                    "A boat that floods with new sensor channels",
                    "alarmed and counted; the others stay linked; F12 stops all boats, this one too",
                    LinkAttacks::newChannels),
            new RobotRow(
                    "A boat whose battery flaps between full and critical",
                    "alarmed as a flood; no list of alarms grows with it",
                    LinkAttacks::flappingBattery),
            new RobotRow(
                    "Clients that ask for the command without end",
                    "alarmed as a flood; no list of messages grows with it",
                    LinkAttacks::endlessWishes),
            new RobotRow(
                    "A boat named with HTML that loads a picture",
                    "the name is text in lists and map; nobody is asked for the picture",
                    LinkAttacks::htmlName),
            new RobotRow(
                    "A boat named with escape codes and a change of direction",
                    "it is no boat; its address has a row that says why; nothing of the name is shown",
                    LinkAttacks::escapedName),
            new RobotRow(
                    "A boat with the name of another one",
                    "an alarm names both addresses; the first keeps its link",
                    LinkAttacks::twin),
            new RobotRow(
                    "A connection dropped in the middle of a frame, again and again",
                    "the link is made again; the losses are a fault with their count",
                    LinkAttacks::droppedInMidFrame),
            new RobotRow(
                    "A frame without an end",
                    "the link is lost and said so; the other boats stay linked",
                    LinkAttacks::endlessFrame),
            new RobotRow(
                    "A frame of two gigabytes",
                    "the connection is closed; the other boats stay linked",
                    LinkAttacks::hugeFrame),
            new RobotRow(
                    "Noise in place of a boat",
                    "its address has a row that says that nothing there is a boat",
                    LinkAttacks::noise),
            new RobotRow(
                    "A server that accepts and says nothing",
                    "its address has a row that says so, and the count is short of one boat",
                    LinkAttacks::silence),
            new RobotRow(
                    "A boat that lies about its position",
                    "an alarm doubts the position; the other boats are where they were",
                    LinkAttacks::lyingPosition),
            new RobotRow(
                    "A boat whose time goes backwards",
                    "its link stays fresh; ages and positions go on",
                    LinkAttacks::timeBackwards),
            new RobotRow(
                    "Numbers that cannot be: latitude 999, 1e400, NaN",
                    "none of them is taken; the boat stays where it was",
                    LinkAttacks::impossibleNumbers),
            new RobotRow(
                    "A message nested ten thousand deep",
                    "it is not taken; the window and the other boats go on",
                    LinkAttacks::deeplyNested),
            new RobotRow(
                    "A boat that answers the commands of others",
                    "the others' commands go on as if nothing had been said",
                    LinkAttacks::answersForOthers),
            new RobotRow(
                    "A boat that comes under ever new names",
                    "eight are taken, the rest is counted and alarmed",
                    LinkAttacks::everNewNames),
            new RobotRow(
                    "The id of a stop taken by another client",
                    "F12 stops the boat all the same",
                    RealBoatAttacks::stopIdTaken),
            new RobotRow(
                    "A fleet stop latched by another base",
                    "the window is red, and names the base that stopped the boat",
                    RealBoatAttacks::stopByAnotherBase));

    private static final int MANY = 20_000;
    private static final int MOST_NEWS = 40; // a flood must not become as many lines

    private LinkAttacks() {}

    /** Connects what answers as a boat, looks, and gives it up. */
    private static void with(RobotWorld world, FakeBoat boat, RobotRow.Act look) throws Exception {
        try (boat) {
            world.session().fleet().connect(boat.address());
            look.on(world);
            assertThat(world.boat("anna").link()).isEqualTo(LinkState.LINKED);
            assertThat(world.boat("bert").link()).isEqualTo(LinkState.LINKED);
        } finally {
            RobotWorld.get(world.session().fleet().disconnect(boat.address()));
        }
    }

    private static FakeBoat flooding(String id, IntFunction<LinkMessage> message) throws IOException {
        return new FakeBoat(id, (connection, mouth) -> {
            mouth.say(FakeBoat.at(0.002, 1));
            for (int i = 0; i < MANY; i++) {
                mouth.say(message.apply(i));
            }
        });
    }

    private static void newChannels(RobotWorld world) throws Exception {
        FakeBoat mad = flooding("mad", i -> new SensorReport("sonde", "channel " + i, List.of(1.0), "m", 25, 51, i));
        with(world, mad, now -> {
            world.until(
                    "it is alarmed",
                    () -> world.alarm(Alarm.Kind.LINK_FLOOD, "mad").isPresent());
            world.robot.press(VK_F12);
            world.until("anna and bert are stopped", world::allStopped);
            world.until("it is told to stop", () -> mad.commands.contains("fleet-stop"));
            world.warned("readings");
        });
    }

    private static void flappingBattery(RobotWorld world) throws Exception {
        int before = world.session().models().alarms().snapshot().size();
        FakeBoat flap = flooding(
                "flap",
                i -> new BatteryReport(i % 2 == 0 ? 95 : 3, i % 2 == 0 ? BatteryLevel.NOMINAL : BatteryLevel.CRITICAL));
        with(world, flap, now -> {
            world.until(
                    "it is alarmed",
                    () -> world.alarm(Alarm.Kind.LINK_FLOOD, "flap").isPresent());
            assertThat(world.session().models().alarms().snapshot().size() - before)
                    .isLessThan(MOST_NEWS);
        });
    }

    private static void endlessWishes(RobotWorld world) throws Exception {
        int before = world.session().models().messages().snapshot().size();
        FakeBoat asked = flooding("asked", i -> new CommandAsked("client" + i));
        with(world, asked, now -> {
            world.until(
                    "it is alarmed",
                    () -> world.alarm(Alarm.Kind.LINK_FLOOD, "asked").isPresent());
            assertThat(world.session().models().messages().snapshot().size() - before)
                    .isLessThan(MOST_NEWS);
        });
    }

    private static void htmlName(RobotWorld world) throws Exception {
        AtomicInteger asked = new AtomicInteger();
        try (ServerSocket web = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
            Thread listens = new Thread(
                    () -> {
                        try {
                            while (true) {
                                web.accept().close();
                                asked.incrementAndGet();
                            }
                        } catch (IOException over) {
                            // the row is over
                        }
                    },
                    "web");
            listens.setDaemon(true);
            listens.start();
            String name = "<html><b>B</b><img src=http://127.0.0.1:" + web.getLocalPort() + "/x>";
            FakeBoat html = new FakeBoat(name, (connection, mouth) -> mouth.say(FakeBoat.at(0.001, 1)));
            with(world, html, now -> {
                world.until(
                        "it has a row with its name as it is",
                        () -> world.boatRows().contains(name));
                world.robot.clickRow("boats-table", name);
                world.run("panel-boat");
                world.until(
                        "the panel of the boat has its name",
                        () -> world.text("boat-name").contains("<b>"));
                world.run("panel-boats");
                assertThat(asked.get()).as("who asked for the picture").isZero();
            });
        }
    }

    private static void escapedName(RobotWorld world) throws Exception {
        try (FakeBoat evil = new FakeBoat("\\u001b[2J\\u202eevil", (connection, mouth) -> {})) {
            unreached(world, evil.address(), "U+001B is a control character");
            assertThat(world.boatRows()).doesNotContain("evil");
        }
    }

    private static void twin(RobotWorld world) throws Exception {
        BoatAddress twin = world.fleet().launchTwin("bert");
        world.session().fleet().connect(twin);
        try {
            world.warned("two boats are named bert");
            assertThat(world.boat("bert").link()).isEqualTo(LinkState.LINKED);
        } finally {
            RobotWorld.get(world.session().fleet().disconnect(twin));
            world.fleet().end("bert again");
        }
    }

    private static void droppedInMidFrame(RobotWorld world) throws Exception {
        FakeBoat drops = new FakeBoat("drops", (connection, mouth) -> {
            mouth.say(FakeBoat.at(0.002, 1));
            if (connection < 6) {
                byte[] frame = LinkCodec.STANDARD.encode(0, FakeBoat.at(0.002, 2));
                mouth.sendRaw(Arrays.copyOf(frame, frame.length / 2));
                mouth.hangUp();
            }
        });
        with(world, drops, now -> {
            world.warned("The link to drops was lost");
            world.until("it has connected again and again", () -> drops.connections() >= 4);
        });
    }

    private static void endlessFrame(RobotWorld world) throws Exception {
        FakeBoat endless = new FakeBoat("endless", (connection, mouth) -> {
            mouth.say(FakeBoat.at(0.002, 1));
            mouth.sendRaw(ByteBuffer.allocate(8).putInt(4_000_000).put((byte) 2).array());
        });
        with(
                world,
                endless,
                now -> world.until(
                        "its link is lost",
                        () -> world.boats().stream()
                                .anyMatch(boat -> boat.boat().equals("endless") && boat.link() == LinkState.LOST)));
    }

    private static void hugeFrame(RobotWorld world) throws Exception {
        FakeBoat huge = new FakeBoat("huge", (connection, mouth) -> {
            mouth.say(FakeBoat.at(0.002, 1));
            mouth.sendRaw(ByteBuffer.allocate(4).putInt(Integer.MAX_VALUE).array());
        });
        with(world, huge, now -> world.until("it was closed and tried again", () -> huge.connections() >= 2));
    }

    private static void noise(RobotWorld world) throws Exception {
        SplittableRandom random = new SplittableRandom(30);
        try (ServerSocket noise = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
            Thread makes = new Thread(
                    () -> {
                        byte[] bytes = new byte[4096];
                        for (int i = 0; i < bytes.length; i++) {
                            bytes[i] = (byte) random.nextInt();
                        }
                        bytes[0] = 0; // a length within bounds
                        bytes[1] = 0;
                        try {
                            while (true) {
                                noise.accept().getOutputStream().write(bytes);
                            }
                        } catch (IOException over) {
                            // the row is over
                        }
                    },
                    "noise");
            makes.setDaemon(true);
            makes.start();
            unreached(world, new BoatAddress("127.0.0.1", noise.getLocalPort()), "");
        }
    }

    private static void silence(RobotWorld world) throws Exception {
        try (ServerSocket silent = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
            unreached(
                    world,
                    new BoatAddress("127.0.0.1", silent.getLocalPort()),
                    "something listens there, and says nothing that a boat would say");
        }
    }

    private static void unreached(RobotWorld world, BoatAddress address, String why) throws Exception {
        world.session().fleet().connect(address);
        try {
            world.until(
                    "its row says that no boat answers",
                    () -> world.boatRows().contains(address.toString())
                            && world.boatRows().contains(why));
            world.until("it counts", () -> world.text("boats-count").startsWith("2 of 3"));
        } finally {
            RobotWorld.get(world.session().fleet().disconnect(address));
        }
    }

    private static void lyingPosition(RobotWorld world) throws Exception {
        FakeBoat liar = new FakeBoat("liar", (connection, mouth) -> {
            for (int i = 0; i < 40; i++) {
                mouth.say(FakeBoat.at(i % 2 == 0 ? 0.002 : 0.08, i));
                LockSupport.parkNanos(100_000_000);
            }
        });
        with(world, liar, now -> {
            world.until(
                    "its position is doubted",
                    () -> world.alarm(Alarm.Kind.POSITION_DOUBTFUL, "liar").isPresent());
            assertThat(world.boat("anna").pose().orElseThrow().position().lonDeg())
                    .isLessThan(51.53);
        });
    }

    private static void timeBackwards(RobotWorld world) throws Exception {
        FakeBoat back = new FakeBoat("back", (connection, mouth) -> {
            for (int i = 0; i < 60; i++) {
                mouth.say(FakeBoat.at(0.002 + i * 1e-7, 1_000_000_000_000L - i * 10_000_000_000L));
                LockSupport.parkNanos(100_000_000);
            }
        });
        with(world, back, now -> {
            world.until(
                    "it has moved on",
                    () -> world.boats().stream()
                            .filter(boat -> boat.boat().equals("back"))
                            .anyMatch(boat -> boat.pose().isPresent()
                                    && boat.pose().get().position().lonDeg() > 51.5288 + 20 * 1e-7));
            assertThat(world.boat("back").link()).isEqualTo(LinkState.LINKED);
            assertThat(world.text("links-count")).contains("links fresh");
        });
    }

    private static void impossibleNumbers(RobotWorld world) throws Exception {
        FakeBoat odd = new FakeBoat("odd", (connection, mouth) -> {
            mouth.say(FakeBoat.at(0.002, 1));
            for (String lat : List.of("999", "1e400", "NaN", "-1e308", "\"25\"", "null")) {
                mouth.sayText("{\"type\":\"telemetry\",\"seq\":9,\"lat\":" + lat
                        + ",\"lon\":0,\"heading\":0,\"speed\":0,\"battery\":50,\"mode\":\"STOPPED\",\"time\":5}");
            }
            mouth.say(new Progress("odd-end", 0, false));
        });
        with(world, odd, now -> {
            world.until(
                    "it is where it said first",
                    () -> world.boats().stream()
                            .anyMatch(boat ->
                                    boat.boat().equals("odd") && boat.pose().isPresent()));
            assertThat(world.boat("odd").pose().orElseThrow().position().lonDeg())
                    .isEqualTo(FakeBoat.at(0.002, 1).lonDeg());
        });
    }

    private static void deeplyNested(RobotWorld world) throws Exception {
        FakeBoat deep = new FakeBoat("deep", (connection, mouth) -> {
            mouth.say(FakeBoat.at(0.002, 1));
            mouth.sayText(
                    "{\"type\":\"held\",\"seq\":1,\"waypoints\":" + "[".repeat(10_000) + "]".repeat(10_000) + "}");
            mouth.say(FakeBoat.at(0.003, 2));
        });
        with(
                world,
                deep,
                now -> world.until(
                        "what came after it is taken",
                        () -> world.boats().stream()
                                .filter(boat -> boat.boat().equals("deep"))
                                .anyMatch(boat -> boat.pose().isPresent()
                                        && boat.pose().get().position().lonDeg() > 51.5296)));
    }

    private static void answersForOthers(RobotWorld world) throws Exception {
        FakeBoat echo = new FakeBoat("echo", (connection, mouth) -> {
            mouth.say(FakeBoat.at(0.002, 1));
            for (int i = 0; i < 500; i++) {
                mouth.say(new Ack("c" + i));
                mouth.say(new Ack("fleet-stop#" + i));
                mouth.say(new Progress("m1-1#" + i, 99, true));
            }
        });
        long mission = world.explore(1);
        with(world, echo, now -> {
            world.until(
                    "it has come",
                    () -> world.boats().stream().anyMatch(boat -> boat.boat().equals("echo")));
            assertThat(world.boat("anna").points()).isPositive();
            assertThat(world.running()).anyMatch(one -> one.id() == mission);
        });
    }

    private static void everNewNames(RobotWorld world) throws Exception {
        FakeBoat names = new FakeBoat(
                connection -> "name" + connection, (connection, mouth) -> mouth.say(FakeBoat.at(0.002, 1)));
        List<String> come = new ArrayList<>();
        with(world, names, now -> {
            world.robot.until(
                    "the limit is alarmed",
                    60,
                    () -> world.session().models().alarms().snapshot().stream()
                            .anyMatch(alarm -> alarm.text().contains("under ever new names")));
            world.boats().forEach(boat -> come.add(boat.boat()));
            assertThat(come.stream().filter(name -> name.startsWith("name"))).hasSizeLessThanOrEqualTo(8);
            world.warned("not taken");
        });
        for (String name : come) {
            if (name.startsWith("name")) {
                RobotWorld.get(world.session().fleet().disconnect(name));
            }
        }
    }
}
