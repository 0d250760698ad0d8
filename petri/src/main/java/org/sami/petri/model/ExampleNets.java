package org.sami.petri.model;

import java.util.List;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;

/** Nets that the literature measures with, made for any number of parts. How many states they have is said where it is known. */
public final class ExampleNets {
    /** How many steps an agent of {@link #agents} goes through. */
    private static final int STEPS = 10;

    /** The steps between which an agent holds the gate. */
    private static final int GATE_OPENS = 2;

    private static final int GATE_CLOSES = 7;

    private ExampleNets() {}

    /**
     * A production line of four cells with {@code cards} kanban cards each (Ciardo and Tilgner, 1996): 160, 4,600, 58,400, 454,475 and 2,546,432 states with one to
     * five cards.
     */
    public static PetriNet kanban(int cards) {
        PetriNetBuilder net = new PetriNetBuilder("kanban-" + cards);
        addKanban(net, cards);
        return net.build();
    }

    /** The same line with a place without bound that counts what has left it: a coverability set of as many markings as the line has states. */
    public static PetriNet openKanban(int cards) {
        PetriNetBuilder net = new PetriNetBuilder("open-kanban-" + cards);
        addKanban(net, cards);
        net.produce(net.transitionNumber("leave"), net.place("finished", 0), 1);
        return net.build();
    }

    private static void addKanban(PetriNetBuilder net, int cards) {
        for (int cell = 1; cell <= 4; cell++) {
            net.place("kanban" + cell, cards);
            net.place("machine" + cell, 0);
            net.place("rework" + cell, 0);
            net.place("out" + cell, 0);
            net.move("fail" + cell, List.of("machine" + cell), List.of("rework" + cell));
            net.move("back" + cell, List.of("rework" + cell), List.of("machine" + cell));
            net.move("done" + cell, List.of("machine" + cell), List.of("out" + cell));
        }
        net.move("enter", List.of("kanban1"), List.of("machine1"));
        net.move("split", List.of("out1", "kanban2", "kanban3"), List.of("kanban1", "machine2", "machine3"));
        net.move("join", List.of("out2", "out3", "kanban4"), List.of("kanban2", "kanban3", "machine4"));
        net.move("leave", List.of("out4"), List.of("kanban4"));
    }

    /** Dining philosophers who take either fork first and lay both down together: {@code 3^n} states, two of them deadlocks. */
    public static PetriNet philosophers(int count) {
        PetriNetBuilder net = new PetriNetBuilder("philosophers-" + count);
        for (int i = 0; i < count; i++) {
            net.place("fork" + i, 1);
            net.place("thinks" + i, 1);
            net.place("left" + i, 0);
            net.place("right" + i, 0);
            net.place("eats" + i, 0);
        }
        for (int i = 0; i < count; i++) {
            String left = "fork" + i;
            String right = "fork" + (i + 1) % count;
            net.move("takeLeft" + i, List.of("thinks" + i, left), List.of("left" + i));
            net.move("takeRight" + i, List.of("thinks" + i, right), List.of("right" + i));
            net.move("thenRight" + i, List.of("left" + i, right), List.of("eats" + i));
            net.move("thenLeft" + i, List.of("right" + i, left), List.of("eats" + i));
            net.move("layDown" + i, List.of("eats" + i), List.of("thinks" + i, left, right));
        }
        return net.build();
    }

    /** A ring of stations, of which one may work while it holds the token: {@code 3 n 2^(n-1)} states. */
    public static PetriNet tokenRing(int stations) {
        PetriNetBuilder net = new PetriNetBuilder("token-ring-" + stations);
        for (int i = 0; i < stations; i++) {
            net.place("idle" + i, 1);
            net.place("waits" + i, 0);
            net.place("works" + i, 0);
            net.place("token" + i, i == 0 ? 1 : 0);
        }
        for (int i = 0; i < stations; i++) {
            String token = "token" + i;
            net.move("ask" + i, List.of("idle" + i), List.of("waits" + i));
            net.move("begin" + i, List.of("waits" + i, token), List.of("works" + i));
            net.move("end" + i, List.of("works" + i), List.of("idle" + i, token));
            net.move("pass" + i, List.of(token), List.of("token" + (i + 1) % stations));
        }
        return net.build();
    }

    /** Agents that go through ten steps each, five of them within a gate that has room for one: equal agents may be exchanged. */
    public static PetriNet agents(int count) {
        PetriNetBuilder net = new PetriNetBuilder("agents-" + count);
        net.place("gate", 1);
        for (int agent = 0; agent < count; agent++) {
            for (int step = 0; step <= STEPS; step++) {
                net.place("step" + agent + "." + step, step == 0 ? 1 : 0);
            }
            for (int step = 0; step < STEPS; step++) {
                int move = net.move(
                        "go" + agent + "." + step,
                        List.of("step" + agent + "." + step),
                        List.of("step" + agent + "." + (step + 1)));
                if (step == GATE_OPENS) {
                    net.consume(move, net.placeNumber("gate"), 1);
                } else if (step == GATE_CLOSES) {
                    net.produce(move, net.placeNumber("gate"), 1);
                }
            }
        }
        return net.build();
    }

    /** Processors with a memory each, which use their own memory, or over a common bus that of another: 1,863 states with five. */
    public static PetriNet sharedMemory(int processors) {
        PetriNetBuilder net = new PetriNetBuilder("shared-memory-" + processors);
        net.place("bus", 1);
        for (int i = 0; i < processors; i++) {
            net.place("active" + i, 1);
            net.place("memory" + i, 1);
            net.place("queue" + i, 0);
            net.place("own" + i, 0);
        }
        for (int i = 0; i < processors; i++) {
            String active = "active" + i;
            net.move("ask" + i, List.of(active), List.of("queue" + i));
            net.move("beginOwn" + i, List.of(active, "memory" + i), List.of("own" + i));
            net.move("endOwn" + i, List.of("own" + i), List.of(active, "memory" + i));
            for (int other = 0; other < processors; other++) {
                if (other != i) {
                    String access = "access" + i + "." + other;
                    String memory = "memory" + other;
                    net.place(access, 0);
                    net.move("begin" + i + "." + other, List.of("queue" + i, "bus", memory), List.of(access, memory));
                    net.move("end" + i + "." + other, List.of(access), List.of(active, "bus"));
                }
            }
        }
        return net.build();
    }

    /** A producer and a consumer with a buffer of some room; with room 0 the buffer has no bound. */
    public static PetriNet producerConsumer(int room) {
        PetriNetBuilder net = new PetriNetBuilder("producer-consumer-" + room);
        net.place("ready", 1);
        net.place("made", 0);
        net.place("buffer", 0);
        net.place("waits", 1);
        net.place("taken", 0);
        net.move("make", List.of("ready"), List.of("made"));
        int put = net.move("put", List.of("made"), List.of("ready", "buffer"));
        int take = net.move("take", List.of("buffer", "waits"), List.of("taken"));
        net.move("use", List.of("taken"), List.of("waits"));
        if (room > 0) {
            int free = net.place("free", room);
            net.consume(put, free, 1).produce(take, free, 1);
        }
        return net.build();
    }

    /**
     * The pathway in which the protein RKIP keeps Raf-1 from passing on a signal by ERK, with so many molecules of each of the five kinds that are there at first.
     * Source: Heiner, Gilbert and Donaldson, "Petri nets for systems and synthetic biology", SFM 2008, LNCS 5016; 13 states with one molecule, 47,047 with ten.
     */
    public static PetriNet erk(int molecules) {
        PetriNetBuilder net = new PetriNetBuilder("erk-" + molecules);
        List.of("Raf", "RKIP", "ERK", "MEKPP", "RP").forEach(kind -> net.place(kind, molecules));
        List.of("RKIPP", "ERKPP", "Raf_RKIP", "Raf_RKIP_ERKPP", "MEKPP_ERK", "RKIPP_RP")
                .forEach(kind -> net.place(kind, 0));
        net.move("k1", List.of("Raf", "RKIP"), List.of("Raf_RKIP"));
        net.move("k2", List.of("Raf_RKIP"), List.of("Raf", "RKIP"));
        net.move("k3", List.of("Raf_RKIP", "ERKPP"), List.of("Raf_RKIP_ERKPP"));
        net.move("k4", List.of("Raf_RKIP_ERKPP"), List.of("Raf_RKIP", "ERKPP"));
        net.move("k5", List.of("Raf_RKIP_ERKPP"), List.of("Raf", "ERK", "RKIPP"));
        net.move("k6", List.of("ERK", "MEKPP"), List.of("MEKPP_ERK"));
        net.move("k7", List.of("MEKPP_ERK"), List.of("ERK", "MEKPP"));
        net.move("k8", List.of("MEKPP_ERK"), List.of("MEKPP", "ERKPP"));
        net.move("k9", List.of("RKIPP", "RP"), List.of("RKIPP_RP"));
        net.move("k10", List.of("RKIPP_RP"), List.of("RKIPP", "RP"));
        net.move("k11", List.of("RKIPP_RP"), List.of("RKIP", "RP"));
        return net.build();
    }

    /**
     * A circadian clock of two genes, of which there are at most so many molecules of each of five kinds. Source: Vilar, Kueh, Barkai and Leibler, "Mechanisms of noise
     * resistance in genetic oscillators", PNAS 99, 2002; {@code 4 (n+1)^5} states: 128 with one molecule, as in the Model Checking Contest.
     */
    public static PetriNet circadianClock(int molecules) {
        PetriNetBuilder net = new PetriNetBuilder("circadian-clock-" + molecules);
        List.of("mA", "mR", "A", "R", "AR").forEach(kind -> {
            net.place(kind, 0);
            net.place("no_" + kind, molecules);
        });
        for (String kind : List.of("A", "R")) {
            String gene = "gene" + kind;
            String messenger = "m" + kind;
            net.place(gene, 1);
            net.place(gene + "_A", 0);
            net.move("bind" + kind, List.of(gene, "A"), List.of(gene + "_A", "no_A"));
            net.move("unbind" + kind, List.of(gene + "_A", "no_A"), List.of(gene, "A"));
            net.move("transcribe" + kind, List.of(gene, "no_" + messenger), List.of(gene, messenger));
            net.move("activated" + kind, List.of(gene + "_A", "no_" + messenger), List.of(gene + "_A", messenger));
            net.move("translate" + kind, List.of(messenger, "no_" + kind), List.of(messenger, kind));
            net.move("decay" + messenger, List.of(messenger), List.of("no_" + messenger));
            net.move("decay" + kind, List.of(kind), List.of("no_" + kind));
        }
        net.move("join", List.of("A", "R", "no_AR"), List.of("AR", "no_A", "no_R"));
        net.move("decayAR", List.of("AR", "no_R"), List.of("R", "no_AR"));
        return net.build();
    }
}
