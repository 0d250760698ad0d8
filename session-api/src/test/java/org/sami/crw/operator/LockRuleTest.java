package org.sami.crw.operator;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.crw.operator.mission.MissionsSnapshot;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** The lock rule (docs/threads.md), with engine, models and fleet on threads of their own. */
@Timeout(900)
class LockRuleTest {
    private final ExecutorService owner = Executors.newSingleThreadExecutor();
    private final ExecutorService engine = Executors.newSingleThreadExecutor();
    private final ModelWorld world = new ModelWorld(owner, engine);
    private final CountDownLatch never = new CountDownLatch(1);
    private final CountDownLatch blocked = new CountDownLatch(1);

    @AfterEach
    void end() throws InterruptedException {
        owner.shutdownNow();
        engine.shutdownNow();
        assertThat(owner.awaitTermination(60, TimeUnit.SECONDS)).isTrue();
        assertThat(engine.awaitTermination(60, TimeUnit.SECONDS)).isTrue();
    }

    @Test
    void aListenerThatBlocksForEverHoldsUpNeitherEngineNorFleet() throws Exception {
        world.models.missions().addListener(missions -> {
            blocked.countDown();
            awaitQuietly(never);
        });
        world.host.post(ModelWorld.start("first"));
        assertThat(blocked.await(60, TimeUnit.SECONDS)).isTrue();

        for (int i = 0; i < 1000; i++) {
            world.host.post(ModelWorld.start("more"));
        }
        int missions = 0;
        while (missions < 1001) { // the engine works on; else this test takes its whole time
            missions = world.host.query(view -> view.missions().size()).get(60, TimeUnit.SECONDS);
        }

        BoatProxy boat = world.boat("anna"); // this thread is the fleet's
        for (int mission = 1; mission <= 1000; mission++) {
            boat.commands()
                    .submit(FollowPath.of("c" + mission, mission, 1, List.of(GeoPoint.of(45, 10)), Priority.MEDIUM));
            world.models.look();
        }
        assertThat(boat.commands().waiting()).as("the fleet has worked on").hasSize(999);

        world.models.tell(message("a message"));
        world.models.messages().acknowledge(1);
        world.models.refresh(world.host, ModelWorld.VOCABULARY);
        assertThat(world.models.missions().snapshot().missions())
                .as("what was last shown")
                .hasSize(1);
    }

    @Test
    void aListenerThatThrowsHoldsUpNobodyAndTheNextIsTold() throws Exception {
        List<MissionsSnapshot> told = new ArrayList<>();
        CountDownLatch both = new CountDownLatch(2);
        world.models.missions().addListener(missions -> {
            throw new IllegalStateException("a window that fails");
        });
        world.models.missions().addListener(missions -> {
            told.add(missions);
            both.countDown();
        });
        world.host.post(ModelWorld.start("first"));
        world.host.query(view -> 0).get(60, TimeUnit.SECONDS);
        owner.submit(() -> {}).get(60, TimeUnit.SECONDS);
        world.host.post(ModelWorld.start("second"));

        assertThat(both.await(60, TimeUnit.SECONDS)).isTrue();
        assertThat(told.get(told.size() - 1).running())
                .extracting(MissionSnapshot::name)
                .contains("first", "second");
    }

    @Test
    void aListenerMayTellTheModelsAndTheHostWithoutWaiting() throws Exception {
        CountDownLatch acknowledged = new CountDownLatch(1);
        world.models.messages().addListener(messages -> {
            world.models.messages().acknowledge(messages.get(0).number());
            world.host.post(new Input.TimeReached());
            if (messages.get(0).acknowledged()) {
                acknowledged.countDown();
            }
        });

        world.models.tell(message("hello"));

        assertThat(acknowledged.await(60, TimeUnit.SECONDS)).isTrue();
    }

    private static OperatorMessage message(String text) {
        return new OperatorMessage(0, Ids.NONE, OperatorMessage.Source.DOMAIN, Priority.LOW, text, List.of(), "");
    }

    private static void awaitQuietly(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
