package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;

/** The vocabulary against its sources and against what is built: no event that nothing handles. */
class EventCatalogueTest {
    /** Appendix .2.1, in its order. */
    private static final List<String> APPENDIX_OUTPUTS = List.of(
            "ProxySetDescription",
            "ProxyExecutePath",
            "ProxyExecutePathAndBlock",
            "ProxyGotoPoint",
            "ProxyGotoPointAndBlock",
            "ProxyExploreArea",
            "ProxyResendWaypoints",
            "ConnectExistingProxy",
            "ConnectExistingProxyId",
            "CreateSimulatedProxy",
            "SetGains",
            "BlockMovement",
            "ProxyGotoLatLon",
            "AllocationRequest",
            "PathRequest",
            "AssembleLocationRequest",
            "ProxyCompareDistanceRequest",
            "StartSystemTimer",
            "StartProxyTimer",
            "GetAllProxyTokens",
            "BatteryLevelSubscription",
            "DisplayMessage",
            "OperatorAllocationOptions",
            "OperatorPathOptions",
            "OperatorSelectBoat",
            "OperatorSelectBoatList",
            "OperatorSelectBoatId",
            "OperatorCreateArea",
            "OperatorApprove",
            "DefineVariables",
            "RedefineVariables",
            "SelectVariable",
            "ReturnValue",
            "SendAbortMission",
            "SendProxyAbortAllMissions",
            "SendProxyAbortFutureMissions",
            "ProxyAbortMission",
            "GenerateTasks",
            "RefreshTasks",
            "TaskComplete");

    /** Appendix .2.2, in its order. */
    private static final List<String> APPENDIX_INPUTS = List.of(
            "ProxyPathCompleted",
            "ProxyCreated",
            "ProxyPoseUpdated",
            "AllocationResponse",
            "PathResponse",
            "BatteryNominal",
            "BatteryLow",
            "BatteryCritical",
            "AssembleLocationResponse",
            "TimerExpired",
            "ProxyTimerExpired",
            "TokensReturned",
            "QuantityGreater",
            "QuantityLess",
            "QuantityEqual",
            "OperatorAcceptedAllocation",
            "OperatorRejectedAllocation",
            "OperatorAcceptsPath",
            "OperatorRejectsPath",
            "OperatorSelectsBoat",
            "OperatorSelectsBoatList",
            "OperatorSelectsBoatId",
            "OperatorCreatedArea",
            "YesOption",
            "NoOption",
            "DefinedVariablesReceived",
            "RedefinedVariablesReceived",
            "VariableSelected",
            "CheckReturn",
            "ProxyAbortMissionReceived",
            "OperatorInterruptReceived",
            "TaskDelayed",
            "TaskReassigned",
            "TaskReleased",
            "TaskStarted",
            "TaskUnassigned");

    private final TestWorld world = new TestWorld(new ScriptedEngine(TestWorld.VOCABULARY));

    @Test
    void theAppendixIsDeclaredWholeAndByItsNames() {
        assertThat(APPENDIX_OUTPUTS).hasSize(40).allSatisfy(name -> assertDeclared(name, Direction.OUTPUT));
        assertThat(APPENDIX_INPUTS).hasSize(36).allSatisfy(name -> assertDeclared(name, Direction.INPUT));
    }

    private static void assertDeclared(String name, Direction direction) {
        EventType type = TestWorld.VOCABULARY.events().get(name);
        assertThat(type).as(name).isNotNull();
        assertThat(type.direction()).as(name).isEqualTo(direction);
        assertThat(type.help()).as(name).endsWith(".");
    }

    /** An output event is a question to the operator, the engine's own, or has a handler. */
    @Test
    void everyOutputEventIsHandled() {
        Set<String> unhandled = new TreeSet<>();
        for (EventType type : TestWorld.VOCABULARY.events().values()) {
            if (type.direction() == Direction.OUTPUT
                    && type.decision().isEmpty()
                    && type.role() == EventRole.NONE
                    && !world.domain.handledTypes().contains(type.name())) {
                unhandled.add(type.name());
            }
        }

        assertThat(unhandled).isEmpty();
        assertThat(TestWorld.VOCABULARY.events().keySet()).containsAll(world.domain.handledTypes());
    }

    /** Each event by the effect that its row of the {@link EventCatalogue} names. */
    @TestFactory
    Stream<DynamicTest> eachEventHasTheEffectThatItsRowNames() {
        return EventCatalogue.whole().rows().values().stream()
                .map(row -> DynamicTest.dynamicTest(
                        row.event() + " (" + row.seen() + "): " + row.effect(),
                        () -> row.check().run()));
    }

    @Test
    void everyEventHasARow() {
        Set<String> without = new TreeSet<>(TestWorld.VOCABULARY.events().keySet());
        without.removeAll(EventCatalogue.whole().rows().keySet());

        assertThat(without).isEmpty();
    }
}
