package org.sami.bench;

import java.lang.management.ManagementFactory;
import java.util.Map;
import javax.management.JMException;
import javax.management.ObjectName;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.protocol.Input;

/** How much memory a mission takes that has ten robots and waits. */
final class MissionMemory {
    private static final int MISSIONS = 2000;

    private MissionMemory() {}

    /** Bytes of live objects per mission, from the virtual machine's own class histogram. */
    static double bytesPerIdleMission() throws JMException {
        Engine engine = Rings.robots(10);
        EngineState state = engine.newState();
        for (int i = 0; i < 10; i++) {
            engine.step(state, 0, new Input.ProxyJoined("robot" + i));
        }
        engine.step(state, 0, new Input.StartMission("ring", "ring", Map.of()));
        long before = liveBytes();
        for (int i = 0; i < MISSIONS; i++) {
            engine.step(state, 0, new Input.StartMission("ring", "ring", Map.of()));
        }
        long after = liveBytes();
        if (engine.view(state).missions().size() != MISSIONS + 1) {
            throw new IllegalStateException("Not all missions run");
        }
        return (double) (after - before) / MISSIONS;
    }

    /** The total of {@code jcmd GC.class_histogram}, which counts live objects only. */
    private static long liveBytes() throws JMException {
        String histogram = (String) ManagementFactory.getPlatformMBeanServer()
                .invoke(
                        new ObjectName("com.sun.management:type=DiagnosticCommand"),
                        "gcClassHistogram",
                        new Object[] {new String[0]},
                        new String[] {String[].class.getName()});
        String[] total =
                histogram.substring(histogram.lastIndexOf("Total")).trim().split("\\s+");
        return Long.parseLong(total[2]);
    }
}
