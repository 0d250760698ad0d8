package org.sami.crw.fleet;

import java.util.function.Consumer;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.link.LeftOut;
import org.sami.crw.proxy.listener.BoatListener;
import org.sami.crw.proxy.queue.CommandQueueSnapshot;
import org.sami.crw.proxy.queue.Withdrawal;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.proxy.status.BoatReading;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.spn.value.GeoPoint;

/** Makes a {@link FleetEvent} of each call of a proxy. */
final class BoatEventPublisher implements BoatListener {
    private final Consumer<FleetEvent> events;

    BoatEventPublisher(Consumer<FleetEvent> events) {
        this.events = events;
    }

    @Override
    public void onCompleted(String boatId, BoatCommand command) {
        events.accept(new FleetEvent.CommandCompleted(boatId, command));
    }

    @Override
    public void onFailed(String boatId, BoatCommand command, String reason) {
        events.accept(new FleetEvent.CommandFailed(boatId, command, reason));
    }

    @Override
    public void onHoldsPlace(String boatId, BoatCommand givenUp) {
        events.accept(new FleetEvent.PlaceHeld(boatId, givenUp));
    }

    @Override
    public void onWithdrawn(String boatId, BoatCommand command, Withdrawal why) {
        events.accept(new FleetEvent.CommandWithdrawn(boatId, command, why));
    }

    @Override
    public void onPanorama(String boatId, BoatCommand command, int pictures, GeoPoint from) {
        events.accept(new FleetEvent.PanoramaTaken(boatId, command, pictures, from));
    }

    @Override
    public void onProgress(String boatId, BoatCommand command, int visitedCount) {
        events.accept(new FleetEvent.Progressed(boatId, command, visitedCount));
    }

    @Override
    public void onQueueChanged(String boatId, CommandQueueSnapshot queue) {
        events.accept(new FleetEvent.QueueChanged(boatId, queue));
    }

    @Override
    public void onUpload(String boatId, Upload upload) {
        events.accept(new FleetEvent.UploadAdvanced(boatId, upload));
    }

    @Override
    public void onTakenOver(String boatId) {
        events.accept(new FleetEvent.TakenOver(boatId));
    }

    @Override
    public void onReleased(String boatId) {
        events.accept(new FleetEvent.HandedBack(boatId));
    }

    @Override
    public void onStatus(BoatStatus status) {
        events.accept(new FleetEvent.StatusReported(status));
    }

    @Override
    public void onLinkChange(BoatStatus status) {
        events.accept(new FleetEvent.LinkChanged(status));
    }

    @Override
    public void onBattery(String boatId, BatteryState battery) {
        events.accept(new FleetEvent.BatteryReported(boatId, battery));
    }

    @Override
    public void onRestarted(BoatStatus status) {
        events.accept(new FleetEvent.Restarted(status));
    }

    @Override
    public void onRestartAllowed(BoatStatus status) {
        events.accept(new FleetEvent.RestartAllowed(status));
    }

    @Override
    public void onRetired(String boatId) {
        events.accept(new FleetEvent.Retired(boatId));
    }

    @Override
    public void onCommanding(String boatId, boolean commands) {
        events.accept(new FleetEvent.CommanderChanged(boatId, commands));
    }

    @Override
    public void onCommandAsked(String boatId, String clientId) {
        events.accept(new FleetEvent.CommandAsked(boatId, clientId));
    }

    @Override
    public void onReading(String boatId, BoatReading reading) {
        events.accept(new FleetEvent.Measured(boatId, reading));
    }

    @Override
    public void onLeftOut(String boatId, LeftOut leftOut) {
        events.accept(new FleetEvent.TooMuchSent(boatId, leftOut));
    }

    @Override
    public void onTuning(String boatId, BoatTuning tuning) {
        events.accept(new FleetEvent.SettingsReported(boatId, tuning));
    }

    @Override
    public void onTuningTaken(String boatId, String commandId) {
        events.accept(new FleetEvent.SettingTaken(boatId, commandId));
    }

    @Override
    public void onTuningRefused(String boatId, String commandId, String reason) {
        events.accept(new FleetEvent.SettingRefused(boatId, commandId, reason));
    }

    @Override
    public void onRefused(String boatId, String reason) {
        events.accept(new FleetEvent.Refused(boatId, reason));
    }

    @Override
    public void onListenerFault(String listener, Throwable fault) {
        events.accept(new FleetEvent.Fault("a listener of boats, " + listener, fault));
    }
}
