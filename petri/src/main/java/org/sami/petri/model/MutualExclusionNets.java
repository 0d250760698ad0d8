package org.sami.petri.model;

import java.util.ArrayList;
import java.util.List;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;

/** Algorithms by which processes with shared variables enter a critical section one at a time, a transition for each read or write of a variable. */
public final class MutualExclusionNets {
    private final PetriNetBuilder net;
    private final int processes;

    private MutualExclusionNets(String name, int processes) {
        net = new PetriNetBuilder(name);
        this.processes = processes;
    }

    /**
     * Peterson's algorithm for {@code tours + 1} processes ("Myths about the mutual exclusion problem", Information Processing Letters 12, 1981): each goes through so
     * many tours. In a tour it writes that it came last, and goes on when another came after it, or when it has seen of each other process that it does not want in.
     * The steps are those of the net in the Model Checking Contest: 20,754 states with two tours.
     */
    public static PetriNet peterson(int tours) {
        MutualExclusionNets nets = new MutualExclusionNets("peterson-" + tours, tours + 1);
        for (int i = 0; i <= tours; i++) {
            nets.addPeterson(i, tours);
        }
        return nets.net.build();
    }

    private void addPeterson(int i, int tours) {
        move("ask" + i, List.of(start("idle" + i), start("rests" + i)), List.of("wants" + i, "asks" + i + ".0"));
        for (int tour = 0; tour < tours; tour++) {
            String at = i + "." + tour;
            String mine = last(tour, i);
            for (int k = 0; k < processes; k++) {
                move("write" + at + "." + k, List.of("asks" + at, last(tour, k)), List.of(mine, "reads" + at));
                if (k != i) {
                    move(
                            "after" + at + "." + k,
                            List.of("reads" + at, last(tour, k)),
                            List.of(last(tour, k), "through" + at));
                }
                addLook(i, at, k);
            }
            move("last" + at, List.of("reads" + at, mine), List.of(mine, "begins" + at + ".0"));
            move("seen" + at, List.of("looked" + at + "." + (processes - 1)), List.of("through" + at));
            move(
                    "next" + at,
                    List.of("through" + at),
                    List.of(tour + 1 < tours ? "asks" + i + "." + (tour + 1) : "critical" + i));
        }
        move("leave" + i, List.of("critical" + i, "wants" + i), List.of("idle" + i, "rests" + i));
    }

    /** A process that came last in a tour looks whether another one wants in. */
    private void addLook(int i, String at, int other) {
        String here = at + "." + other;
        move("look" + here, List.of("begins" + here), List.of("compares" + here));
        if (other == i) {
            move("self" + here, List.of("compares" + here), List.of("looked" + here));
        } else {
            move("other" + here, List.of("compares" + here), List.of("tests" + here));
            move(
                    "rests" + here,
                    List.of("tests" + here, start("rests" + other)),
                    List.of("rests" + other, "looked" + here));
            move("wants" + here, List.of("tests" + here, "wants" + other), List.of("wants" + other, "reads" + at));
        }
        if (other + 1 < processes) {
            move("go" + here, List.of("looked" + here), List.of("begins" + at + "." + (other + 1)));
        }
    }

    /** Who came last in a tour; at first it is process 0. */
    private String last(int tour, int process) {
        String id = "last" + tour + "." + process;
        return process == 0 ? start(id) : id;
    }

    /**
     * Lamport's fast algorithm ("A fast mutual exclusion algorithm", ACM Transactions on Computer Systems 5, 1987): a process that is alone enters after seven accesses
     * to shared variables, however many processes there are. The steps are those of the net in the Model Checking Contest: 380 states with two processes.
     */
    public static PetriNet lamport(int processes) {
        MutualExclusionNets nets = new MutualExclusionNets("lamport-" + processes, processes);
        for (int i = 1; i <= processes; i++) {
            nets.addLamport(i);
        }
        return nets.net.build();
    }

    private void addLamport(int i) {
        set("raise" + i, start("start" + i), "b" + i, "setX" + i);
        for (int value = 0; value <= processes; value++) {
            String to = i + "." + value;
            write("x", "setX" + to, "setX" + i, value, i, "ifY0" + i);
            read("y", "ifY0" + to, "ifY0" + i, value, value == 0 ? "setY" + i : "lower" + i);
            write("y", "setY" + to, "setY" + i, value, i, "ifX" + i);
            read("x", "ifX" + to, "ifX" + i, value, value == i ? "critical" + i : "yield" + i);
            read("y", "ifY" + to, "ifY" + i, value, value == i ? "critical" + i : "await" + i);
            write("y", "clearY" + to, "critical" + i, value, 0, "leave" + i);
        }
        clear("lower" + i, "lower" + i, "b" + i, "await" + i);
        read("y", "await" + i, "await" + i, 0, "start" + i);
        clear("yield" + i, "yield" + i, "b" + i, "for" + i);
        clear("leave" + i, "leave" + i, "b" + i, "start" + i);
        List<String> waiting = new ArrayList<>(List.of("all" + i));
        List<String> done = new ArrayList<>(List.of("all" + i));
        for (int other = 1; other <= processes; other++) {
            String pair = i + "." + other;
            String clear = start("not-b" + other);
            move("await" + pair, List.of("all" + i, "waits" + pair, clear), List.of("all" + i, "seen" + pair, clear));
            waiting.add("waits" + pair);
            done.add("seen" + pair);
        }
        move("for" + i, List.of("for" + i), waiting);
        move("all" + i, done, List.of("ifY" + i));
    }

    private void read(String variable, String id, String at, int value, String next) {
        move(id + "?", List.of(at, value(variable, value)), List.of(value(variable, value), next));
    }

    private void write(String variable, String id, String at, int old, int value, String next) {
        move(id + "!", List.of(at, value(variable, old)), List.of(value(variable, value), next));
    }

    /** A variable has the value 0 at first. */
    private String value(String variable, int value) {
        return value == 0 ? start(variable + "0") : variable + value;
    }

    private void set(String id, String at, String bit, String next) {
        move(id + ".0", List.of(at, start("not-" + bit)), List.of(bit, next));
        move(id + ".1", List.of(at, bit), List.of(bit, next));
    }

    private void clear(String id, String at, String bit, String next) {
        move(id + ".0", List.of(at, start("not-" + bit)), List.of("not-" + bit, next));
        move(id + ".1", List.of(at, bit), List.of("not-" + bit, next));
    }

    /** A transition; places that are not there yet are made, without a token. */
    private void move(String id, List<String> from, List<String> to) {
        for (List<String> places : List.of(from, to)) {
            for (String place : places) {
                if (!net.hasPlace(place)) {
                    net.place(place, 0);
                }
            }
        }
        net.move(id, from, to);
    }

    /** A place with a token at first, which is made where it is not there yet. */
    private String start(String place) {
        if (!net.hasPlace(place)) {
            net.place(place, 1);
        }
        return place;
    }
}
